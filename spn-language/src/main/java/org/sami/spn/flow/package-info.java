/**
 * Which kinds of tokens can come where in a plan, by what its edges require: one bound from above for the checks and for all that is proposed
 * to authors. Answers about plans; no window, no running.
 */
@NullMarked
package org.sami.spn.flow;

import org.jspecify.annotations.NullMarked;
