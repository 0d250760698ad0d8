package org.sami.session.record;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.sami.boat.link.LostLinkAction;
import org.sami.spn.journal.TelemetryRow;

/** What a session wishes that its boats do when their link is lost, as rows of the journal's telemetry: the newest counts. */
public final class LostLinkWishRows {
    /** Kind of the rows. */
    public static final String KIND = "lost-link-wish";

    private static final ObjectMapper JSON = new ObjectMapper();
    private static final String ACTION = "action";
    private static final String NOTHING = "nothing";

    private LostLinkWishRows() {}

    /** A wish as the JSON of a row: its {@link #word}. */
    public static ObjectNode json(Optional<LostLinkAction> wish) {
        return JSON.createObjectNode().put(ACTION, word(wish));
    }

    /** A wish in one word, such as {@code return}, or {@code nothing}. */
    public static String word(Optional<LostLinkAction> wish) {
        return wish.map(action -> action.name().toLowerCase(Locale.ROOT)).orElse(NOTHING);
    }

    /** The action of a word, whatever its case; empty for every other text. */
    public static Optional<LostLinkAction> action(String word) {
        return Arrays.stream(LostLinkAction.values())
                .filter(action -> action.name().equalsIgnoreCase(word))
                .findFirst();
    }

    /** Whether a word says that nothing is wished. */
    public static boolean isNothing(String word) {
        return word.equals(NOTHING);
    }

    /** The wish after these rows, of any kind and in their order; a row that makes no sense changes nothing. */
    public static Optional<LostLinkAction> after(List<TelemetryRow> rows, Optional<LostLinkAction> before) {
        Optional<LostLinkAction> wish = before;
        for (TelemetryRow row : rows) {
            if (row.kind().equals(KIND)) {
                String word = word(row);
                Optional<LostLinkAction> action = action(word);
                if (action.isPresent() || isNothing(word)) {
                    wish = action;
                }
            }
        }
        return wish;
    }

    private static String word(TelemetryRow row) {
        try {
            return JSON.readTree(row.json()).path(ACTION).asText();
        } catch (JsonProcessingException senseless) {
            return "";
        }
    }
}
