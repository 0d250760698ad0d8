package org.sami.spn.journal;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sami.spn.host.JournalException;
import org.sami.spn.json.ProtocolJson;
import org.sami.spn.json.UnreadableJsonException;
import org.sami.spn.protocol.Input;

/**
 * How an input stands in the file: one line of JSON. A loaded project is named by the SHA-256 of its document, which stands
 * once in {@link ProjectDocuments} however often it is loaded.
 */
final class InputText {
    private static final String LOAD = "{\"input\":\"load-project\",\"sha256\":\"";
    private static final byte[] LOAD_BYTES = LOAD.getBytes(StandardCharsets.UTF_8);
    private static final Pattern LOADED = Pattern.compile(Pattern.quote(LOAD) + "([0-9a-f]{64})\"\\}");

    private InputText() {}

    static String write(Input input) {
        return input instanceof Input.LoadProject load ? LOAD + load.sha256() + "\"}" : ProtocolJson.inputText(input);
    }

    /**
     * The input of an entry whose checksum holds.
     *
     * @throws JournalException where this program cannot read it: it was written by one that speaks otherwise
     */
    static Input read(String where, long index, String text, ProjectDocuments documents) throws JournalException {
        Optional<String> loaded = documentOf(text);
        if (loaded.isPresent()) {
            return documents
                    .find(loaded.get())
                    .map(Input.LoadProject::new)
                    .orElseThrow(() -> new JournalException(where, index, "loads a project whose document is damaged"));
        }
        try {
            return ProtocolJson.readInput(text);
        } catch (UnreadableJsonException unknown) {
            throw new JournalException(where, index, "is no input of this program: " + unknown.getMessage(), unknown);
        }
    }

    /** As the other, of an entry's bytes; there are very many entries that load nothing. */
    static Optional<String> documentOf(byte[] utf8) {
        boolean loads = utf8.length > LOAD_BYTES.length
                && Arrays.equals(utf8, 0, LOAD_BYTES.length, LOAD_BYTES, 0, LOAD_BYTES.length);
        return loads ? documentOf(new String(utf8, StandardCharsets.UTF_8)) : Optional.empty();
    }

    /** The SHA-256 of the document that an entry loads; empty for other entries. */
    static Optional<String> documentOf(String text) {
        if (!text.startsWith(LOAD)) {
            return Optional.empty();
        }
        Matcher matcher = LOADED.matcher(text);
        return matcher.matches() ? Optional.of(matcher.group(1)) : Optional.empty();
    }
}
