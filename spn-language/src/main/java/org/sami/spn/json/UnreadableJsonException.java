package org.sami.spn.json;

import org.sami.spn.finding.Finding;

/** A message, such as an entry of a journal, that this program did not write or no longer understands. */
public final class UnreadableJsonException extends Exception {
    UnreadableJsonException(Finding first) {
        super(first.pointer().isEmpty() ? first.message() : first.pointer() + ": " + first.message());
    }
}
