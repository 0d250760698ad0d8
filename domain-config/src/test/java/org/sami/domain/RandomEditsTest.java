package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditHistory;
import org.sami.spn.edit.EditResult;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Project;
import org.sami.spn.testing.RandomEdits;

/** Whatever is edited in the shipped plans, the project can be saved and opened, and every edit can be taken back. */
class RandomEditsTest {
    private static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final int EDITS = 250;

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void projectStaysReadableAndUndoRestoresIt(long seed) {
        RandomEdits edits = new RandomEdits(seed, LIBRARY.vocabulary());
        EditHistory history = new EditHistory(LIBRARY.combined(), LIBRARY.vocabulary(), EDITS);
        List<Project> versions = new ArrayList<>(List.of(history.project()));
        Set<Class<?>> made = new HashSet<>();
        while (versions.size() <= EDITS) {
            Project before = history.project();
            Edit edit = edits.next(before);
            EditResult result = history.apply(edit);
            if (result instanceof EditResult.Refused || history.project().equals(before)) {
                assertThat(history.project()).isSameAs(before);
            } else {
                made.add(edit.getClass());
                assertSaysWhatItTouched(before, (EditResult.Done) result);
                assertReadable(edit, history.project());
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
