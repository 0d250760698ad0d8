/** Boats: the list of all, worst first, the panel of one, and driving by hand. */
@NullMarked
package org.sami.crw.gui.boat;

import org.jspecify.annotations.NullMarked;
