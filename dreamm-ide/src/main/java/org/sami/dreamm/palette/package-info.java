/**
 * The toolset palette (thesis 5.1): what can be added to a plan, by groups, found by typing, dragged onto the net or added by key. What is
 * offered and where it may go knows no Swing; the net asks what is dragged which edit it is.
 */
@NullMarked
package org.sami.dreamm.palette;

import org.jspecify.annotations.NullMarked;
