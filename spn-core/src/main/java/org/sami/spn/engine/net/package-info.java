/**
 * Plans in index form, compiled once when an engine is made and never changed afterwards. Used by the engine alone.
 *
 * <p>Belongs here: what can be worked out of a plan and the vocabulary before anything runs. Does not belong here: anything that
 * changes in a step. Knows no other package of the engine.
 *
 * <p>Read {@code CompiledProject}, {@code CompiledPlan}, {@code CompiledPlace}, {@code CompiledTransition}.
 */
@NullMarked
package org.sami.spn.engine.net;

import org.jspecify.annotations.NullMarked;
