package org.sami.ui.value;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.IntStream;
import javax.swing.JComponent;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;
import org.sami.spn.component.MarkupOption;
import org.sami.spn.component.Purpose;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.ValueType;
import org.sami.ui.check.Layout;

class ListChooserTest {
    private static JComponent list(int rows) {
        ValueType type = TypeNames.parse("list<proxy>").orElseThrow();
        List<MarkupOption> filter = List.of(MarkupOption.parse("Filter.source").orElseThrow());
        List<ChoiceRow> boats = IntStream.rangeClosed(1, rows)
                .mapToObj(i -> new ChoiceRow(new ProxyValue("boat" + i), "boat" + i, ""))
                .toList();
        return SampleDomain.EDITORS
                .chooser(
                        SampleDomain.CHOICE.choose(Purpose.SELECT, type, filter),
                        ValueField.of("choose", type),
                        new Offer(boats, 1, rows))
                .component();
    }

    @Test
    void aListThatIsSeenAtAGlanceHasNoFieldToSearchIt() throws Exception {
        SwingUtilities.invokeAndWait(() -> {
            assertThat(Layout.find(list(6), "value-choose-filter", JTextField.class))
                    .isEmpty();
            assertThat(Layout.find(list(7), "value-choose-filter", JTextField.class))
                    .isPresent();
        });
    }
}
