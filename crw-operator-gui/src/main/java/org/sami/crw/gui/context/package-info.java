/** What all panels work on: session, commands, selected boats, notices in the strip at the top. */
package org.sami.crw.gui.context;
