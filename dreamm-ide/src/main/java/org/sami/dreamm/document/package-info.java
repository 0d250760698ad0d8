/**
 * The project that is written, with its history, and what of it is open and selected. No window: views listen to it, on the event thread.
 * What an edit does stands in {@code org.sami.spn.edit}.
 */
@NullMarked
package org.sami.dreamm.document;

import org.jspecify.annotations.NullMarked;
