package org.sami.spn.edit;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Note;
import org.sami.spn.model.Project;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.TestVocabulary;

class NoteEditTest {
    private final Project project = NetBuilder.project(new NetBuilder("p")
            .start("s")
            .build()
            .withNotes(List.of(Note.of("one"), Note.of("two"), Note.of("three"))));

    private List<Note> after(Edit edit) {
        return edit.apply(project, TestVocabulary.TEST)
                .project()
                .orElseThrow()
                .plan("p")
                .orElseThrow()
                .notes();
    }

    @Test
    void aNoteGetsAPlaceAndAnotherText() {
        LayoutPoint at = new LayoutPoint(3, 4);

        assertThat(after(new NoteEdit.MoveNotes("p", Map.of(1, at))).get(1))
                .isEqualTo(new Note("two", Optional.of(at)));
        assertThat(after(new NoteEdit.SetNoteText("p", 2, "3")))
                .extracting(Note::text)
                .containsExactly("one", "two", "3");
        assertThat(after(new NoteEdit.AddNote("p", Note.of("four")))).hasSize(4);
    }

    @Test
    void severalAreRemovedByTheIndicesThatTheyHadBefore() {
        assertThat(after(new NoteEdit.RemoveNotes("p", Set.of(0, 1)))).containsExactly(Note.of("three"));
    }

    @Test
    void oneThatIsNotThereIsRefused() {
        assertThat(new NoteEdit.SetNoteText("p", 3, "").apply(project, TestVocabulary.TEST))
                .isEqualTo(new EditResult.Refused("The plan \"p\" has no note 4"));
    }
}
