package org.sami.spn.journal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.spn.engine.Engine;
import org.sami.spn.host.JournalException;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.json.VocabularyFiles;
import org.sami.spn.json.VocabularyReader;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.testing.NetBuilder;

class JournalPlansTest {
    private static final String DOMAIN = "{\"formatVersion\": 1, \"domain\": \"test\", \"label\": \"Test\","
            + " \"files\": [\"events.json\"], \"library\": []}";
    private static final String EVENTS = "{\"events\": ["
            + "{\"name\": \"Go\", \"direction\": \"output\", \"label\": \"Go\", \"help\": \"Goes.\", \"answers\": [\"Went\"]},"
            + "{\"name\": \"Went\", \"direction\": \"input\", \"label\": \"Went\", \"help\": \"Went.\"}]}";
    private static final Project PROJECT = NetBuilder.project(new NetBuilder("trip")
            .start("going")
            .output("going", "Go")
            .end("gone")
            .transition("arrive", "Went")
            .in("going", "arrive", "generic >= 1")
            .out("arrive", "gone", "take all any")
            .build());

    private static final String PROJECT_TEXT = new ProjectWriter(
                    VocabularyReader.read(new VocabularyFiles(Map.of("domain.json", DOMAIN, "events.json", EVENTS)))
                            .orThrow())
            .text(PROJECT);

    @TempDir
    Path folder;

    private static JournalHeader header(String events) {
        Map<String, String> vocabulary = new LinkedHashMap<>();
        vocabulary.put("domain.json", DOMAIN);
        vocabulary.put("events.json", events);
        return JournalHeader.of(PROJECT_TEXT, vocabulary, Map.of());
    }

    @Test
    void aSessionGoesOnWithThePlansThatItsJournalHolds() throws IOException {
        Path file = folder.resolve("session.journal");
        SqliteJournal.create(file, header(EVENTS), JournalOptions.DEFAULT).close();

        try (SqliteJournal journal = SqliteJournal.open(file, JournalOptions.DEFAULT)) {
            Engine engine = JournalPlans.engine(JournalAddress.of(file), journal.header());
            List<Effect> effects =
                    engine.step(journal.restore(engine), 0, new Input.StartMission("trip", "Trip", Map.of()));
            assertThat(effects).hasAtLeastOneElementOfType(Effect.Activated.class);
            assertThat(JournalPlans.project(
                            JournalAddress.of(file),
                            journal.header(),
                            JournalPlans.vocabulary(JournalAddress.of(file), journal.header())))
                    .isEqualTo(PROJECT);
        }
    }

    @Test
    void plansThatThisProgramCannotReadAreNamed() {
        Path file = folder.resolve("session.journal");

        assertThatThrownBy(() -> JournalPlans.engine(JournalAddress.of(file), header("{\"events\": 7}")))
                .isInstanceOf(JournalException.class)
                .hasMessageContaining(file.toString())
                .hasMessageContaining("vocabulary");
        JournalHeader noProject = JournalHeader.of("no JSON", header(EVENTS).vocabulary(), Map.of());
        assertThatThrownBy(() -> JournalPlans.engine(JournalAddress.of(file), noProject))
                .isInstanceOf(JournalException.class)
                .hasMessageContaining("project");
    }
}
