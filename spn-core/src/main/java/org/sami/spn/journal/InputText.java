package org.sami.spn.journal;

import java.nio.file.Path;
import org.sami.spn.json.ProtocolJson;
import org.sami.spn.json.UnreadableJsonException;
import org.sami.spn.protocol.Input;

/** How an input stands in the file: one line of JSON. */
final class InputText {
    private InputText() {}

    static String write(Input input) {
        return ProtocolJson.inputText(input);
    }

    /**
     * The input of an entry whose checksum holds.
     *
     * @throws JournalException where this program cannot read it: it was written by one that speaks otherwise
     */
    static Input read(Path file, long index, String text) throws JournalException {
        try {
            return ProtocolJson.readInput(text);
        } catch (UnreadableJsonException unknown) {
            throw new JournalException(file, index, "is no input of this program: " + unknown.getMessage(), unknown);
        }
    }
}
