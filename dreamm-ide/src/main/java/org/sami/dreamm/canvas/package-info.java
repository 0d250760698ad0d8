/** The model view in the middle of the window: the net of the open plan, on which it is edited (thesis 5.1, Mission Model View). */
package org.sami.dreamm.canvas;
