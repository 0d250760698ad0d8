package org.sami.crw.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.session.archive.SessionJournal;
import org.sami.session.record.LostLinkWishRows;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.journal.TelemetryRow;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Project;

/** The wish of real sessions, over a journal in a file. */
class LostLinkWishTest {
    @TempDir
    private Path folder;

    private Path journal() {
        return folder.resolve("journal");
    }

    private Session begin(Optional<LostLinkAction> asked) throws Exception {
        DomainLibrary library =
                DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
        Project project = library.projectOf("clv").orElseThrow();
        Map<String, String> settings = new HashMap<>();
        LostLinkWish.note(asked, settings);
        JournalHeader header = JournalHeader.of(
                new ProjectWriter(library.vocabulary()).text(project),
                library.files().texts(),
                settings);
        return started(
                SessionSetup.of(library.vocabulary(), project).with(SessionJournal.create(journal(), header)), asked);
    }

    private Session resume(Optional<LostLinkAction> asked) throws Exception {
        return started(SessionSetup.resumed(SessionJournal.open(journal())), asked);
    }

    private static Session started(SessionSetup setup, Optional<LostLinkAction> asked) throws Exception {
        Session session = Session.open(setup);
        session.fleet().wish(asked);
        session.begin();
        return session;
    }

    @Test
    void sessionBeginsWithTheWishOfItsJournalAndGoesOnWithIt() throws Exception {
        try (Session session = begin(Optional.of(LostLinkAction.RETURN))) {
            assertThat(session.fleet().lostLinkWish()).contains(LostLinkAction.RETURN);
        }
        try (Session later = resume(Optional.empty())) {
            assertThat(later.fleet().lostLinkWish()).contains(LostLinkAction.RETURN);
        }
    }

    @Test
    void whatAnOperatorMadeOfItStaysWhereAnotherProcessGoesOn() throws Exception {
        try (Session session = begin(Optional.of(LostLinkAction.RETURN))) {
            session.fleet()
                    .wishLostLink(Optional.of(LostLinkAction.DRIFT))
                    .toCompletableFuture()
                    .get();
        }
        try (Session later = resume(Optional.empty())) {
            assertThat(later.fleet().lostLinkWish()).contains(LostLinkAction.DRIFT);
            later.fleet().wishLostLink(Optional.empty()).toCompletableFuture().get();
        }
        try (Session last = resume(Optional.empty())) {
            assertThat(last.fleet().lostLinkWish()).isEmpty();
        }
    }

    @Test
    void whatAProcessIsStartedWithCountsAndStays() throws Exception {
        try (Session session = begin(Optional.empty())) {
            session.fleet()
                    .wishLostLink(Optional.of(LostLinkAction.DRIFT))
                    .toCompletableFuture()
                    .get();
        }
        try (Session later = resume(Optional.of(LostLinkAction.HOLD))) {
            assertThat(later.fleet().lostLinkWish()).contains(LostLinkAction.HOLD);
        }
        try (Session last = resume(Optional.empty())) {
            assertThat(last.fleet().lostLinkWish()).contains(LostLinkAction.HOLD);
        }
    }

    @Test
    void rowThatMakesNoSenseChangesNothing() {
        List<TelemetryRow> rows = List.of(
                new TelemetryRow(1, "", LostLinkWishRows.KIND, "{\"action\":\"return\"}"),
                new TelemetryRow(2, "", LostLinkWishRows.KIND, "{\"action\":\"swim\"}"),
                new TelemetryRow(3, "", LostLinkWishRows.KIND, "{"),
                new TelemetryRow(4, "anna", "lost", "{\"action\":\"hold\"}"));

        assertThat(LostLinkWishRows.after(rows, Optional.empty())).contains(LostLinkAction.RETURN);
    }
}
