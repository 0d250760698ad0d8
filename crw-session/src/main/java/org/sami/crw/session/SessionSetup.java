package org.sami.crw.session;

import java.io.IOException;
import java.util.Objects;
import java.util.Optional;
import org.sami.crw.handler.planning.CrwServices;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.crw.session.archive.SessionJournal;
import org.sami.crw.session.fault.FaultPolicy;
import org.sami.session.record.SessionPictures;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.VocabularyFiles;
import org.sami.spn.json.VocabularyReader;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * The setup of a session.
 *
 * @param project the project of its plans, which has passed the checks
 * @param journal belongs to the session, which closes it
 * @param services allocation, paths and coverage
 * @param onFault the reaction to a failure of the engine or its journal, in sessions in real time
 * @param pictures where pictures of boats are kept; empty = next to the journal's file, and without one only while somebody attends the session in real time
 */
public record SessionSetup(
        Vocabulary vocabulary,
        Project project,
        SessionJournal journal,
        CrwServices services,
        SessionRuntime runtime,
        FaultPolicy onFault,
        Optional<SessionPictures> pictures) {
    public SessionSetup {
        Objects.requireNonNull(vocabulary, "vocabulary");
        Objects.requireNonNull(project, "project");
        Objects.requireNonNull(journal, "journal");
        Objects.requireNonNull(services, "services");
        Objects.requireNonNull(runtime, "runtime");
        Objects.requireNonNull(onFault, "onFault");
        Objects.requireNonNull(pictures, "pictures");
    }

    /** With pictures where they are usually kept. */
    public SessionSetup(
            Vocabulary vocabulary,
            Project project,
            SessionJournal journal,
            CrwServices services,
            SessionRuntime runtime,
            FaultPolicy onFault) {
        this(vocabulary, project, journal, services, runtime, onFault, Optional.empty());
    }

    /** With somebody who looks after it ({@link FaultPolicy#ATTENDED}). */
    public SessionSetup(
            Vocabulary vocabulary,
            Project project,
            SessionJournal journal,
            CrwServices services,
            SessionRuntime runtime) {
        this(vocabulary, project, journal, services, runtime, FaultPolicy.ATTENDED);
    }

    /**
     * A session without a journal, in real time, on boats behind TCP; those that do not say how far they may be off their ways are taken to be
     * as in the field.
     */
    public static SessionSetup of(Vocabulary vocabulary, Project project) {
        return new SessionSetup(
                vocabulary,
                project,
                SessionJournal.none(),
                CrwServices.STANDARD.drivenWith(CrossTrackError.FIELD),
                SessionRuntime.RealTime.ofThisProcess());
    }

    /**
     * A session that goes on where its journal ends, with the words and the plans that the journal holds.
     *
     * @throws IOException if the journal's documents cannot be read
     */
    public static SessionSetup resumed(SessionJournal journal) throws IOException {
        JournalHeader header =
                journal.header().orElseThrow(() -> new IllegalArgumentException("there is no journal to go on from"));
        Vocabulary vocabulary =
                VocabularyReader.read(new VocabularyFiles(header.vocabulary())).orThrow();
        Project project = new ProjectReader(vocabulary).read(header.project()).orThrow();
        return of(vocabulary, project).with(journal);
    }

    /** The same with another journal. */
    public SessionSetup with(SessionJournal other) {
        return new SessionSetup(vocabulary, project, other, services, runtime, onFault, pictures);
    }

    /** The same on another runtime. */
    public SessionSetup with(SessionRuntime other) {
        return new SessionSetup(vocabulary, project, journal, services, other, onFault, pictures);
    }

    /** The same with other services. */
    public SessionSetup with(CrwServices others) {
        return new SessionSetup(vocabulary, project, journal, others, runtime, onFault, pictures);
    }

    /** The same with something else that is to happen when the engine or its journal fails. */
    public SessionSetup with(FaultPolicy other) {
        return new SessionSetup(vocabulary, project, journal, services, runtime, other, pictures);
    }

    /** The same with pictures kept there. */
    public SessionSetup with(SessionPictures folder) {
        return new SessionSetup(vocabulary, project, journal, services, runtime, onFault, Optional.of(folder));
    }
}
