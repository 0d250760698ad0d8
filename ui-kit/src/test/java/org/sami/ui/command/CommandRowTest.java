package org.sami.ui.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import javax.swing.JButton;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.ui.check.Layout;

class CommandRowTest {
    private final List<CommandButton> buttons = Stream.of("Go to a place", "Hold all of them", "Return home now")
            .map(title -> new CommandButton(new Command(title.replace(' ', '-'), title, () -> {}).withIcon("home")))
            .toList();

    private final CommandRow row = new CommandRow();

    CommandRowTest() {
        row.left(buttons.get(0)).left(buttons.get(1)).right(buttons.get(2));
    }

    @Test
    void allWordsAreThereWhereThereIsRoom() {
        layOut(1000);

        assertThat(buttons).allSatisfy(button -> assertThat(button.getText()).isNotEmpty());
        assertThat(buttons.get(2).getX() + buttons.get(2).getWidth()).isLessThanOrEqualTo(1000);
        assertThat(buttons.get(2).getX()).isGreaterThan(600);
    }

    @ParameterizedTest
    @ValueSource(ints = {180, 250, 320, 400, 500})
    void noButtonIsCutAndNoneLiesOnAnother(int width) {
        layOut(width);

        int end = 0;
        for (CommandButton button : buttons) {
            assertThat(button.getX()).isGreaterThanOrEqualTo(end);
            end = button.getX() + button.getWidth();
            assertThat(button.getWidth()).isEqualTo(button.getPreferredSize().width);
        }
        assertThat(end).isLessThanOrEqualTo(width);
        assertThat(buttons.get(0).getToolTipText()).isEqualTo("Go to a place");
    }

    @Test
    void wordsComeBackWithTheRoom() {
        layOut(180);
        layOut(1000);

        assertThat(buttons).allSatisfy(button -> assertThat(button.getText()).isNotEmpty());
    }

    @ParameterizedTest
    @ValueSource(ints = {60, 90, 120})
    void whatHasNoRoomIsInTheMenuOfALastButton(int width) {
        buttons.forEach(row::leaveOut);
        layOut(width);

        JButton more = Layout.find(row, "more-commands", JButton.class).orElseThrow();
        assertThat(more.isVisible()).isTrue();
        assertThat(more.getWidth()).isPositive();
        assertThat(more.getX() + more.getWidth()).isLessThanOrEqualTo(width);
        long leftOut = buttons.stream().filter(button -> button.getWidth() == 0).count();
        assertThat(leftOut).isPositive();
        assertThat(row.menu().getComponentCount()).isEqualTo((int) leftOut);

        layOut(1000);
        assertThat(more.isVisible()).isFalse();
        assertThat(row.menu().getComponentCount()).isZero();
    }

    private void layOut(int width) {
        row.setSize(width, row.getPreferredSize().height);
        row.doLayout();
    }
}
