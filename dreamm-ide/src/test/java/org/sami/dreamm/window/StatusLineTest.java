package org.sami.dreamm.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import java.util.concurrent.TimeUnit;
import javax.swing.JLabel;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.sami.dreamm.OnEventThread;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.context.LibraryProject;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.profile.Profile;
import org.sami.spn.json.DomainLibrary;
import org.sami.ui.check.Layout;

@ExtendWith(OnEventThread.class)
class StatusLineTest {
    private static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    private final DreammContext context = new DreammContext(
            LIBRARY,
            new ProjectDocument(LIBRARY.vocabulary(), LibraryProject.of(LIBRARY), Optional.empty()),
            Profile.ALL);
    private long nanos;
    private final StatusLine line = new StatusLine(context, new JLabel(), () -> nanos);

    @AfterEach
    void close() {
        context.close();
    }

    private void pass(long seconds) {
        nanos += TimeUnit.SECONDS.toNanos(seconds);
        line.refresh();
    }

    private JLabel notice() {
        return Layout.find(line, "notice", JLabel.class).orElseThrow();
    }

    @Test
    void whatWasDoneLeavesAfterTenSeconds() {
        context.notices().told("Saved in lake.json");
        pass(9);
        assertThat(notice().getText()).isEqualTo("Saved in lake.json");

        pass(2);

        assertThat(notice().getText()).isEmpty();
        assertThat(notice().getIcon()).isNull();
        assertThat(notice().getToolTipText()).isNull();
    }

    @Test
    void whatWasRefusedStaysForHalfAMinute() {
        context.notices().refused("lake.json cannot be written");
        pass(29);
        assertThat(notice().getText()).isEqualTo("lake.json cannot be written");
        assertThat(notice().getAccessibleContext().getAccessibleName()).startsWith("Refused");

        pass(2);

        assertThat(notice().getText()).isEmpty();
    }

    @Test
    void aNoticeBeginsAnewWithTheOneThatFollows() {
        context.notices().told("first");
        pass(8);
        context.notices().told("second");
        pass(8);

        assertThat(notice().getText()).isEqualTo("second");
    }
}
