package org.sami.dreamm.replay;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.host.Durability;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.journal.JournalOptions;
import org.sami.spn.journal.SqliteJournal;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.json.VocabularyFiles;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Input;

/** A journal as a session writes it: two boats join, a mission of the plan clv starts at 1 s, the operator chooses both boats at 5 s. */
public final class RecordedSession {
    private static final String DOMAIN = "/org/sami/domain/crw";

    private RecordedSession() {}

    /** Writes it. */
    public static Path write(Path file) throws IOException {
        DomainLibrary library = DomainLibrary.fromClassPath(DOMAIN).orThrow();
        Project project = library.projectOf("clv").orElseThrow();
        JournalHeader header = JournalHeader.of(
                new ProjectWriter(library.vocabulary()).text(project),
                VocabularyFiles.fromClassPath(DOMAIN).orThrow().texts(),
                Map.of());
        Engine engine = new Engine(library.vocabulary(), project);
        EngineState state = engine.newState();
        List<Input> inputs = List.of(
                new Input.ProxyJoined("anna"),
                new Input.ProxyJoined("bert"),
                new Input.StartMission("clv", "Visit", Map.of()));
        inputs.forEach(input -> engine.step(state, 1000, input));
        long decision = engine.view(state).decisions().get(0).id();
        Input choose =
                new Input.AnswerDecision(decision, new Answer.Proxies(List.of("anna", "bert")), Answerer.OPERATOR);
        try (SqliteJournal journal = SqliteJournal.create(file, header, JournalOptions.DEFAULT)) {
            List<JournalEntry> entries = new ArrayList<>();
            inputs.forEach(input -> entries.add(new JournalEntry(entries.size() + 1, 1000, input)));
            entries.add(new JournalEntry(entries.size() + 1, 5000, choose));
            journal.append(entries, Durability.POWER);
        }
        return file;
    }
}
