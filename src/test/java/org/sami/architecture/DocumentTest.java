package org.sami.architecture;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The documents beside the code: what they point at is there, and every decision names what guards it. */
class DocumentTest {
    private static final Pattern LINK = Pattern.compile("\\]\\(([^)#\\s]+)(#[^)]*)?\\)");

    @Test
    void everyLinkLeadsSomewhere() throws IOException {
        List<String> dead = new ArrayList<>();
        int followed = 0;
        for (Path document : documents()) {
            Matcher links = LINK.matcher(Files.readString(document));
            while (links.find()) {
                String target = links.group(1);
                if (target.contains("://")) {
                    continue;
                }
                followed++;
                if (!Files.exists(document.toAbsolutePath().resolveSibling(target))) {
                    dead.add(document + " -> " + target);
                }
            }
        }

        assertThat(followed).isGreaterThan(5);
        assertThat(dead).isEmpty();
    }

    @Test
    void everyDecisionNamesWhatConfirmsItAndIsListed() throws IOException {
        Path folder = Path.of("docs", "decisions");
        List<Path> decisions;
        try (Stream<Path> all = Files.list(folder)) {
            decisions = all.filter(path -> path.getFileName().toString().matches("\\d{4}-.*\\.md"))
                    .sorted()
                    .toList();
        }
        String list = Files.readString(folder.resolve("README.md"));

        assertThat(decisions).hasSizeGreaterThanOrEqualTo(2);
        for (Path decision : decisions) {
            assertThat(Files.readString(decision)).as(decision.toString()).contains("\nConfirmation: ");
            assertThat(list).contains("(" + decision.getFileName() + ")");
        }
        assertThat(decisions.stream().map(path -> path.getFileName().toString().substring(0, 4)))
                .doesNotHaveDuplicates();
    }

    private static List<Path> documents() throws IOException {
        List<Path> documents = new ArrayList<>();
        try (Stream<Path> top = Files.list(Path.of(""));
                Stream<Path> docs = Files.walk(Path.of("docs"))) {
            Stream.concat(top, docs)
                    .filter(path -> path.toString().endsWith(".md"))
                    .sorted()
                    .forEach(documents::add);
        }
        return documents;
    }
}
