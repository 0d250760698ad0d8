package org.sami.architecture;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The documents next to the code: what they point at is there, and every decision names what guards it. */
class DocumentTest {
    private static final Pattern LINK = Pattern.compile("\\]\\(([^)#\\s]+)(#[^)]*)?\\)");
    private static final Pattern SECTION_LINK = Pattern.compile("\\]\\(([^)#\\s]*)#([^)\\s]+)\\)");
    private static final Pattern HEADING = Pattern.compile("(?m)^#+ (.*)$");
    private static final Pattern TEST_NAME = Pattern.compile("`([A-Z]\\w*Test)(?:\\.(\\w+))?`");

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
    void everyLinkToASectionLeadsToIt() throws IOException {
        List<String> dead = new ArrayList<>();
        int followed = 0;
        for (Path document : documents()) {
            Matcher links = SECTION_LINK.matcher(Files.readString(document));
            while (links.find()) {
                Path target = links.group(1).isEmpty()
                        ? document
                        : document.toAbsolutePath()
                                .resolveSibling(links.group(1))
                                .normalize();
                if (target.toString().endsWith(".md") && Files.exists(target)) {
                    followed++;
                    if (!anchors(target).contains(links.group(2))) {
                        dead.add(document + " -> " + links.group(1) + "#" + links.group(2));
                    }
                }
            }
        }

        assertThat(followed).isGreaterThan(5);
        assertThat(dead).isEmpty();
    }

    /** The anchors that a page's headings have where Markdown is shown: lower case, hyphens for spaces, no other signs. */
    private static Set<String> anchors(Path document) throws IOException {
        Set<String> anchors = new HashSet<>();
        Matcher headings = HEADING.matcher(Files.readString(document));
        while (headings.find()) {
            anchors.add(headings.group(1)
                    .strip()
                    .toLowerCase(Locale.ROOT)
                    .replaceAll("[^\\p{L}\\p{N}_\\- ]", "")
                    .replace(' ', '-'));
        }
        return anchors;
    }

    @Test
    void everyTestThatIsNamedIsThere() throws IOException {
        Map<String, List<Path>> tests = new HashMap<>();
        Stream<Path> ofModules = SamiModule.built().flatMap(module -> module.testSources().stream());
        Stream<Path> ofOthers = Stream.of(Path.of(""), Path.of("domain-config"))
                .flatMap(folder -> SamiModule.Sources.below(folder.resolve("src/test/java")).stream());
        Stream.concat(ofModules, ofOthers)
                .forEach(source -> tests.computeIfAbsent(
                                source.getFileName().toString().replace(".java", ""), name -> new ArrayList<>())
                        .add(source));
        List<String> missing = new ArrayList<>();
        int found = 0;
        for (Path document : documents()) {
            Matcher names = TEST_NAME.matcher(Files.readString(document));
            while (names.find()) {
                if (!isThere(tests.getOrDefault(names.group(1), List.of()), names.group(2))) {
                    missing.add(document + " names " + names.group());
                } else {
                    found++;
                }
            }
        }

        assertThat(found).isGreaterThan(100);
        assertThat(missing).isEmpty();
    }

    /** Whether one of some classes of a name has a method; {@code null} stands for the class alone. */
    private static boolean isThere(List<Path> classes, String method) throws IOException {
        for (Path source : classes) {
            if (method == null || Files.readString(source).contains(" " + method + "(")) {
                return true;
            }
        }
        return false;
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

    /** A stranger reads the README to its end, and finds every page from there. */
    @Test
    void readmeIsShortAndLeadsToEveryPage() throws IOException {
        Path readme = Path.of("README.md").toAbsolutePath();
        Set<Path> reached = new HashSet<>(Set.of(readme));
        Deque<Path> open = new ArrayDeque<>(reached);
        while (!open.isEmpty()) {
            Path page = open.poll();
            Matcher links = LINK.matcher(Files.readString(page));
            while (links.find()) {
                Path target = page.resolveSibling(links.group(1)).normalize();
                if (Files.isDirectory(target)) {
                    target = target.resolve("README.md");
                }
                if (target.toString().endsWith(".md") && Files.exists(target) && reached.add(target)) {
                    open.add(target);
                }
            }
        }
        List<Path> pages = documents().stream().map(Path::toAbsolutePath).toList();

        assertThat(Files.readAllLines(readme)).hasSizeLessThanOrEqualTo(120);
        assertThat(pages).hasSizeGreaterThan(100);
        assertThat(reached).containsAll(pages);
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
