/** Boats: the list of all, worst first, the panel of one, and driving by hand. */
package org.sami.crw.gui.boat;
