/**
 * The drawing of a reachability graph without a window: a box for each state, an arrow for each firing, in layers (Eclipse ELK), and the same graph as text in the
 * language DOT.
 *
 * <p>Does not belong here: the search of states, nets, fonts, colours.
 */
@NullMarked
package org.sami.spn.drawing.states;

import org.jspecify.annotations.NullMarked;
