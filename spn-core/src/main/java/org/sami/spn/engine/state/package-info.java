/**
 * What changes in a step: missions, markings, visits, pending occurrences, timers, open decisions. Used by the engine alone.
 *
 * <p>Belongs here: data and the bookkeeping that keeps one class's lists and counts together. Does not belong here: any rule of
 * the language; nothing here emits an effect. Knows {@code net}.
 *
 * <p>Read {@code NetState}, {@code Mission}, {@code PlaceState}, {@code Visit}, then {@code TransitionState}.
 */
@NullMarked
package org.sami.spn.engine.state;

import org.jspecify.annotations.NullMarked;
