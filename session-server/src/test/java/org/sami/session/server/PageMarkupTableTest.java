package org.sami.session.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.sami.spn.vocabulary.MarkupType;

/** The table of docs/session-page.md says of each markup of the vocabulary what laptop, tablet and phone do with it. */
class PageMarkupTableTest {
    private static final Pattern ROW = Pattern.compile("\\| (\\*.+?) \\| (.+?) \\| (.+?) \\|");
    private static final Pattern NAME = Pattern.compile("\\*([^*]+)\\*");

    @Test
    void eachMarkupHasARowAndEachRowNamesMarkups() throws IOException {
        List<String> named = new ArrayList<>();
        for (String line : Files.readAllLines(Path.of("../docs/session-page.md"))) {
            Matcher row = ROW.matcher(line);
            if (row.matches()) {
                Matcher name = NAME.matcher(row.group(1));
                while (name.find()) {
                    named.add(name.group(1));
                }
            }
        }

        assertThat(named)
                .containsExactlyInAnyOrderElementsOf(ServedPage.LIBRARY.vocabulary().markups().values().stream()
                        .map(MarkupType::label)
                        .toList());
    }
}
