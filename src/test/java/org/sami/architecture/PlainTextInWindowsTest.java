package org.sami.architecture;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Windows show texts as they are written: none is HTML, which would fetch what a name from a file or link tells it to. */
class PlainTextInWindowsTest {
    private static final String BORDER = "PlainTextUI.java"; // gives all components plain texts

    /** What makes HTML of a text, or a tab's title of one that is not written in the source. */
    private static final Pattern HTML = Pattern.compile(
            "<html|html\\.disable|JEditorPane|JTextPane|swing\\.text\\.html|BasicHTML"
                    + "|((addTab|insertTab)\\(|setTitleAt\\([^,]+,)\\s*(?!\\s|\"|PlainTextUI\\.of\\()",
            Pattern.CASE_INSENSITIVE);

    @Test
    void noWindowMakesHtmlOfAText() throws IOException {
        List<String> found = new ArrayList<>();
        int looked = 0;
        for (SamiModule module : List.of(SamiModule.UI_KIT, SamiModule.DREAMM_IDE, SamiModule.OPERATOR_WINDOW)) {
            for (Path source : module.mainSources()) {
                looked++;
                if (!source.endsWith(BORDER)
                        && HTML.matcher(Files.readString(source)).find()) {
                    found.add(source.toString());
                }
            }
        }

        assertThat(looked).isGreaterThan(400);
        assertThat(found).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "label.setText(\"<html>\" + name)",
                "c.putClientProperty(\"html.disable\", false)",
                "new JEditorPane()",
                "tabs.addTab(mission.title(), view)",
                "tabs.setTitleAt(1, mission.title())"
            })
    void noticesWhatMakesHtmlOfAText(String source) {
        assertThat(HTML.matcher(source).find()).isTrue();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "tabs.addTab(\"Plans\", plans)",
                "tabs.addTab(PlainTextUI.of(title), view)",
                "tabs.setTitleAt(index, PlainTextUI.of(title))"
            })
    void allowsTitlesThatAreKnown(String source) {
        assertThat(HTML.matcher(source).find()).isFalse();
    }
}
