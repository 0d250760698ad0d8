/** What all panels work on: session, commands, which boats are selected, what is told in the strip at the top. */
package org.sami.crw.gui.context;
