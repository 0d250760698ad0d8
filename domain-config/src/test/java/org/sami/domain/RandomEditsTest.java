package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.analysis.LiveChecks;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditHistory;
import org.sami.spn.edit.EditResult;
import org.sami.spn.edit.EditSequence;
import org.sami.spn.edit.Fix;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Project;
import org.sami.spn.testing.RandomEdits;

/** Whatever is edited in the shipped plans, the project can be saved and opened, and every edit can be taken back. */
@Tag("long")
class RandomEditsTest {
    private static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final int EDITS = 250;

    /** A project that has become unreadable mostly stays so: it is read back after the first edit of each kind and after every fifth. */
    private static final int READ_EVERY = 5;

    private static final int FILES = 4;

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void projectStaysReadableAndUndoRestoresIt(long seed) {
        RandomEdits edits = new RandomEdits(seed, LIBRARY.vocabulary());
        EditHistory history = new EditHistory(someOfTheLibrary(seed), LIBRARY.vocabulary(), EDITS);
        List<Project> versions = new ArrayList<>(List.of(history.project()));
        Set<Class<?>> made = new HashSet<>();
        while (versions.size() <= EDITS) {
            Project before = history.project();
            Edit edit = edits.next(before);
            EditResult result = history.apply(edit);
            if (result instanceof EditResult.Refused || history.project().equals(before)) {
                assertThat(history.project()).isSameAs(before);
            } else {
                boolean first = made.add(edit.getClass());
                assertSaysWhatItTouched(before, (EditResult.Done) result);
                if (first || versions.size() % READ_EVERY == 0) {
                    assertReadable(edit, history.project());
                }
                versions.add(history.project());
            }
        }
        assertThat(made).hasSizeGreaterThan(30);
        for (int i = EDITS - 1; i >= 0; i--) {
            history.undo();
            assertThat(history.project()).isEqualTo(versions.get(i));
        }
        assertThat(history.undo()).isEmpty();
        assertThat(history.isModified()).isFalse();
        for (int i = 1; i <= EDITS; i++) {
            history.redo();
            assertThat(history.project()).isEqualTo(versions.get(i));
        }
    }

    /** Checked edit by edit, findings are those of a full check each time, and few plans are looked at. */
    @ParameterizedTest
    @ValueSource(longs = {11, 12, 13, 14})
    void liveFindingsAreThoseOfAFullCheck(long seed) {
        RandomEdits edits = new RandomEdits(seed, LIBRARY.vocabulary());
        EditHistory history = new EditHistory(someOfTheLibrary(seed), LIBRARY.vocabulary(), EDITS);
        LiveChecks live = LiveChecks.of(history.project(), LIBRARY.vocabulary());
        long checked = 0;
        long plans = 0;
        for (int made = 0; made < EDITS; ) {
            Edit edit = edits.next(history.project());
            if (made % 10 == 9) {
                history.undo();
                edit = new EditSequence("Undo", List.of());
            }
            if (history.apply(edit) instanceof EditResult.Done) {
                made++;
                live = live.after(history.project());
                checked += live.plansChecked();
                plans += history.project().plans().size();
                assertThat(live.findings())
                        .as("after %s", edit)
                        .isEqualTo(PlanChecks.check(history.project(), LIBRARY.vocabulary()));
            }
        }
        assertThat(checked).isLessThan(plans / 2);
    }

    /** In plans that random edits have spoilt, the edits that findings offer take them away and add no error. */
    @ParameterizedTest
    @ValueSource(longs = {21, 22, 23, 24})
    void fixesMendWhatTheyAreOfferedFor(long seed) {
        RandomEdits edits = new RandomEdits(seed, LIBRARY.vocabulary());
        EditHistory history = new EditHistory(someOfTheLibrary(seed), LIBRARY.vocabulary(), 1);
        Set<String> mended = new TreeSet<>();
        for (int round = 0; round < 6; round++) {
            for (int i = 0; i < 40; i++) {
                history.apply(edits.next(history.project()));
            }
            LiveChecks before = LiveChecks.of(history.project(), LIBRARY.vocabulary());
            for (Finding finding : before.findings()) {
                for (Fix fix : finding.fixes()) {
                    Project fixed = fix.edit()
                            .apply(history.project(), LIBRARY.vocabulary())
                            .project()
                            .orElseThrow();
                    assertMended(
                            finding, fix, before.findings(), before.after(fixed).findings());
                    mended.add(finding.code());
                }
            }
        }
        assertThat(mended).hasSizeGreaterThan(5);
    }

    /** One project of a few of the library's files, others for each seed: what is compared after each edit grows with the project. */
    private static Project someOfTheLibrary(long seed) {
        List<Project> files = LIBRARY.plans().stream()
                .map(plan -> LIBRARY.projectOf(plan.id()).orElseThrow())
                .distinct()
                .toList();
        List<Project> some = IntStream.range(0, FILES)
                .mapToObj(i -> files.get((int) ((seed * FILES + i) % files.size())))
                .toList();
        return new Project(
                "some",
                "Some of the library",
                LIBRARY.vocabulary().domain(),
                some.stream().flatMap(file -> file.globals().stream()).toList(),
                some.stream().flatMap(file -> file.missionTree().stream()).toList(),
                some.stream().flatMap(file -> file.plans().stream()).toList());
    }

    private static void assertMended(Finding finding, Fix fix, List<Finding> before, List<Finding> after) {
        assertThat(words(after)).as("after %s", fix).doesNotContain(words(finding));
        assertThat(words(before.stream().filter(Finding::isError).toList()))
                .as("after %s of %s", fix, finding)
                .containsAll(words(after.stream().filter(Finding::isError).toList()));
    }

    private static List<String> words(List<Finding> findings) {
        return findings.stream().map(RandomEditsTest::words).toList();
    }

    /** Without the names that may have been meant: these follow from what else the plan declares. */
    private static String words(Finding finding) {
        String message = finding.message().replaceAll("; is .* meant\\?", "");
        return finding.plan() + " " + finding.elements() + " " + finding.code() + " " + message;
    }

    private static void assertSaysWhatItTouched(Project before, EditResult.Done done) {
        for (var plan : done.changed().plans()) {
            if (!done.touched().contains(plan.id())) {
                assertThat(before.plan(plan.id())).containsSame(plan);
            }
        }
    }

    private static void assertReadable(Edit edit, Project project) {
        String text = new ProjectWriter(LIBRARY.vocabulary()).text(project);
        Reading<Project> read = new ProjectReader(LIBRARY.vocabulary()).read(text);
        assertThat(read.findings()).as("after %s", edit).isEmpty();
        assertThat(read.result()).as("after %s", edit).contains(project);
    }
}
