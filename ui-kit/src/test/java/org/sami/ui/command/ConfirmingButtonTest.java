package org.sami.ui.command;

import static java.awt.event.InputEvent.BUTTON1_DOWN_MASK;
import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.HierarchyEvent;
import java.awt.event.MouseEvent;
import org.junit.jupiter.api.Test;

class ConfirmingButtonTest {
    private static final long SHOWN_MS = 5_000;

    private int confirmed;
    private final CommandButton button =
            CommandButton.confirming(new Command("confirm", "Confirm", () -> confirmed++), () -> SHOWN_MS);

    @Test
    void aClickOnWhatIsShownConfirms() {
        show();
        click(SHOWN_MS + 1, 1);

        assertThat(confirmed).isEqualTo(1);
    }

    @Test
    void theSecondClickOfADoubleClickConfirmsNothing() {
        show();
        click(SHOWN_MS + 1, 2);

        assertThat(confirmed).isZero();
    }

    @Test
    void aClickThatWasMadeBeforeItWasShownConfirmsNothingHoweverLateItArrives() {
        show();
        click(SHOWN_MS - 1, 1);

        assertThat(confirmed).isZero();
    }

    private void show() {
        button.setSize(200, 50);
        button.dispatchEvent(new HierarchyEvent(
                button, HierarchyEvent.HIERARCHY_CHANGED, button, button, HierarchyEvent.SHOWING_CHANGED));
    }

    private void click(long whenMs, int count) {
        for (int id : new int[] {MouseEvent.MOUSE_PRESSED, MouseEvent.MOUSE_RELEASED}) {
            button.dispatchEvent(
                    new MouseEvent(button, id, whenMs, BUTTON1_DOWN_MASK, 20, 20, count, false, MouseEvent.BUTTON1));
        }
    }
}
