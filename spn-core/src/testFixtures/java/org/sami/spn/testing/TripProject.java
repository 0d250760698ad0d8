package org.sami.spn.testing;

import java.util.LinkedHashMap;
import java.util.Map;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.json.VocabularyFiles;
import org.sami.spn.json.VocabularyReader;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/** A project of one plan, {@code trip}: it starts in one place, whose event Go is answered by Went. For tests of journals, which need its texts. */
public final class TripProject {
    private static final Map<String, String> FILES = files();

    /** The domain of the project: the events Go and Went. */
    public static final Vocabulary VOCABULARY =
            VocabularyReader.read(new VocabularyFiles(FILES)).orThrow();

    private TripProject() {}

    private static Map<String, String> files() {
        Map<String, String> files = new LinkedHashMap<>();
        files.put(
                "domain.json",
                "{\"formatVersion\": 1, \"domain\": \"test\", \"label\": \"Test\", \"files\": [\"events.json\"],"
                        + " \"library\": []}");
        files.put(
                "events.json",
                "{\"events\": [{\"name\": \"Go\", \"direction\": \"output\", \"label\": \"Go\", \"help\": \"Goes.\","
                        + " \"answers\": [\"Went\"]}, {\"name\": \"Went\", \"direction\": \"input\", \"label\": \"Went\","
                        + " \"help\": \"Went.\"}]}");
        return files;
    }

    /** The project, whose plan starts in a place of this id. */
    public static Project startingIn(String place) {
        return NetBuilder.project(new NetBuilder("trip")
                .start(place)
                .output(place, "Go")
                .end("gone")
                .transition("arrive", "Went")
                .in(place, "arrive", "generic >= 1")
                .out("arrive", "gone", "take all any")
                .build());
    }

    /** The text of {@link #startingIn}, as a file has it. */
    public static String text(String place) {
        return new ProjectWriter(VOCABULARY).text(startingIn(place));
    }

    /** The header of a journal of the project that starts in {@code going}. */
    public static JournalHeader header(Map<String, String> settings) {
        return JournalHeader.of(text("going"), FILES, settings);
    }
}
