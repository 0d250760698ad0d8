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
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.testing.TripProject;

class JournalPlansTest {
    private static final JournalHeader HEADER = TripProject.header(Map.of());

    @TempDir
    Path folder;

    private static JournalHeader withEvents(String events) {
        Map<String, String> vocabulary = new LinkedHashMap<>(HEADER.vocabulary());
        vocabulary.put("events.json", events);
        return JournalHeader.of(HEADER.project(), vocabulary, Map.of());
    }

    @Test
    void aSessionGoesOnWithThePlansThatItsJournalHolds() throws IOException {
        Path file = folder.resolve("session.journal");
        SqliteJournal.create(file, HEADER, JournalOptions.DEFAULT).close();

        try (SqliteJournal journal = SqliteJournal.open(file, JournalOptions.DEFAULT)) {
            Engine engine = JournalPlans.engine(JournalAddress.of(file), journal.header());
            List<Effect> effects =
                    engine.step(journal.restore(engine), 0, new Input.StartMission("trip", "Trip", Map.of()));
            assertThat(effects).hasAtLeastOneElementOfType(Effect.Activated.class);
            assertThat(JournalPlans.project(
                            JournalAddress.of(file),
                            journal.header(),
                            JournalPlans.vocabulary(JournalAddress.of(file), journal.header())))
                    .isEqualTo(TripProject.startingIn("going"));
        }
    }

    @Test
    void plansThatThisProgramCannotReadAreNamed() {
        Path file = folder.resolve("session.journal");

        assertThatThrownBy(() -> JournalPlans.engine(JournalAddress.of(file), withEvents("{\"events\": 7}")))
                .isInstanceOf(JournalException.class)
                .hasMessageContaining(file.toString())
                .hasMessageContaining("vocabulary");
        JournalHeader noProject = JournalHeader.of("no JSON", HEADER.vocabulary(), Map.of());
        assertThatThrownBy(() -> JournalPlans.engine(JournalAddress.of(file), noProject))
                .isInstanceOf(JournalException.class)
                .hasMessageContaining("project");
    }
}
