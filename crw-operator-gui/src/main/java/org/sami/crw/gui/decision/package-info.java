/**
 * What the operator decides: the decision that is shown in full, those that wait behind it, and what they speak of on the map.
 *
 * <p>Belongs here: which decision is shown and when it may be replaced ({@link org.sami.crw.gui.decision.ShownDecision}, without Swing), and the
 * panel. Does not belong here: what decisions mean and how their markups are read ({@code org.sami.crw.decision}), the components that they
 * are answered with ({@code org.sami.ui.value}).
 */
@NullMarked
package org.sami.crw.gui.decision;

import org.jspecify.annotations.NullMarked;
