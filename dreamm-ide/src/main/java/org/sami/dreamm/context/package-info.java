/** What all panels of DREAMM work on: document, editor's state, commands, words of the domain, the status line, work off the event thread. */
@NullMarked
package org.sami.dreamm.context;

import org.jspecify.annotations.NullMarked;
