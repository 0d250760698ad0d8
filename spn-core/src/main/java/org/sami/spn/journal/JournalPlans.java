package org.sami.spn.journal;

import java.nio.file.Path;
import java.util.stream.Collectors;
import org.sami.spn.engine.Engine;
import org.sami.spn.finding.Finding;
import org.sami.spn.host.JournalException;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.Reading;
import org.sami.spn.json.VocabularyFiles;
import org.sami.spn.json.VocabularyReader;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/** The plans that a journal holds, and no others: a resume runs what ran. */
public final class JournalPlans {
    private JournalPlans() {}

    /**
     * The vocabulary with which the session ran.
     *
     * @param file named in the fault
     * @throws JournalException where this program cannot read it
     */
    public static Vocabulary vocabulary(Path file, JournalHeader header) throws JournalException {
        return usable(file, "vocabulary", VocabularyReader.read(new VocabularyFiles(header.vocabulary())));
    }

    /**
     * The project that ran.
     *
     * @param file named in the fault
     * @throws JournalException where this program cannot read it
     */
    public static Project project(Path file, JournalHeader header, Vocabulary vocabulary) throws JournalException {
        return usable(file, "project", new ProjectReader(vocabulary).read(header.project()));
    }

    /**
     * An engine for the session's plans.
     *
     * @param file named in the fault
     * @throws JournalException where this program cannot read them
     */
    public static Engine engine(Path file, JournalHeader header) throws JournalException {
        Vocabulary vocabulary = vocabulary(file, header);
        return new Engine(vocabulary, project(file, header, vocabulary));
    }

    private static <T> T usable(Path file, String what, Reading<T> reading) throws JournalException {
        return reading.result()
                .orElseThrow(() -> new JournalException(
                        file,
                        0,
                        "its " + what + " cannot be read: "
                                + reading.findings().stream()
                                        .map(Finding::message)
                                        .collect(Collectors.joining("; ")),
                        null));
    }
}
