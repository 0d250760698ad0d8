package org.sami.spn.journal;

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
     * @param journal named in the fault
     * @throws JournalException where this program cannot read it
     */
    public static Vocabulary vocabulary(JournalAddress journal, JournalHeader header) throws JournalException {
        return usable(journal, "vocabulary", VocabularyReader.read(new VocabularyFiles(header.vocabulary())));
    }

    /**
     * The project that ran.
     *
     * @param journal named in the fault
     * @throws JournalException where this program cannot read it
     */
    public static Project project(JournalAddress journal, JournalHeader header, Vocabulary vocabulary)
            throws JournalException {
        return usable(journal, "project", new ProjectReader(vocabulary).read(header.project()));
    }

    /**
     * An engine for the session's plans.
     *
     * @param journal named in the fault
     * @throws JournalException where this program cannot read them
     */
    public static Engine engine(JournalAddress journal, JournalHeader header) throws JournalException {
        Vocabulary vocabulary = vocabulary(journal, header);
        return new Engine(vocabulary, project(journal, header, vocabulary));
    }

    private static <T> T usable(JournalAddress journal, String what, Reading<T> reading) throws JournalException {
        return reading.result()
                .orElseThrow(() -> new JournalException(
                        journal.toString(),
                        0,
                        "its " + what + " cannot be read: "
                                + reading.findings().stream()
                                        .map(Finding::message)
                                        .collect(Collectors.joining("; ")),
                        null));
    }
}
