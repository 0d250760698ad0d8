/** What an author adds to a plan, with the sequence that comes with it: the additions themselves, without Swing, and the strip that offers sequences. */
package org.sami.dreamm.wizard;
