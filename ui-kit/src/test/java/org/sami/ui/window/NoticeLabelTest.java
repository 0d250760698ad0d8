package org.sami.ui.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.sami.palette.SemanticColor;

class NoticeLabelTest {
    private final Notices notices = new Notices();
    private long nanos;
    private final NoticeLabel label = new NoticeLabel(notices, () -> nanos);

    private void pass(long seconds) {
        nanos += TimeUnit.SECONDS.toNanos(seconds);
        label.refresh();
    }

    @Test
    void whatWasDoneLeavesAfterTenSeconds() {
        notices.show("Saved in lake.json");
        pass(9);
        assertThat(label.getText()).isEqualTo("Saved in lake.json");
        assertThat(label.getToolTipText()).isEqualTo("Saved in lake.json");

        pass(2);

        assertThat(label.getText()).isEmpty();
        assertThat(label.getIcon()).isNull();
        assertThat(label.getToolTipText()).isNull();
    }

    @Test
    void whatWasRefusedStaysForHalfAMinuteAndDiffersInMoreThanItsColour() {
        notices.refused("lake.json cannot be written");
        pass(29);
        assertThat(label.getText()).isEqualTo("lake.json cannot be written");
        assertThat(label.getAccessibleContext().getAccessibleName()).startsWith("Refused");
        assertThat(label.getForeground()).isEqualTo(SemanticColor.WARNING.get());
        assertThat(label.getIcon()).isNotNull();

        pass(2);

        assertThat(label.getText()).isEmpty();
    }

    @Test
    void aNoticeBeginsAnewWithTheOneThatFollows() {
        notices.show("first");
        pass(8);
        notices.show("second");
        pass(8);

        assertThat(label.getText()).isEqualTo("second");
    }
}
