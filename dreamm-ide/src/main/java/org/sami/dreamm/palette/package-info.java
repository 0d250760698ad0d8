/**
 * The toolset palette (thesis 5.1): what can be added to a plan, by groups, found by typing, dragged onto the net or added by key. What is
 * offered and where it may go knows no Swing; the net takes a {@link org.sami.dreamm.palette.PaletteDrop} from a drag and asks nothing else.
 */
package org.sami.dreamm.palette;
