package org.sami.dreamm.document;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.sami.spn.edit.ProjectEdit;
import org.sami.spn.edit.RemoveElements;
import org.sami.spn.edit.VertexEdit;
import org.sami.spn.json.DomainLibrary;

class EditorStateTest {
    private static final DomainLibrary DOMAIN =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    private final ProjectDocument document =
            new ProjectDocument(DOMAIN.vocabulary(), DOMAIN.combined(), Optional.empty());
    private final EditorState editor = new EditorState(document);

    @Test
    void aPlanThatGetsAnotherIdStaysOpen() {
        editor.open("station-keep");

        document.apply(new ProjectEdit.RenamePlan("station-keep", "keep-station"));

        assertThat(editor.planId()).contains("keep-station");
    }

    @Test
    void aPlanThatIsDeletedIsOpenNoLonger() {
        editor.open("station-keep");

        document.apply(new ProjectEdit.RemovePlan("station-keep"));

        assertThat(editor.planId()).contains("clv");
        document.undo();
        assertThat(document.plan("station-keep")).isPresent();
    }

    @Test
    void whatIsDeletedIsSelectedNoLonger() {
        editor.open("clv");
        List<String> places =
                editor.plan().orElseThrow().places().stream().map(p -> p.id()).toList();
        editor.select(places.subList(0, 2));
        List<Set<String>> heard = new ArrayList<>();
        editor.addListener(new EditorListener() {
            @Override
            public void selectionChanged() {
                heard.add(editor.selection());
            }
        });

        document.apply(new RemoveElements("clv", Set.of(places.get(0))));

        assertThat(heard).containsExactly(Set.of(places.get(1)));
    }

    @Test
    void listenersHearWhichElementsOfAPlanDiffer() {
        List<Set<String>> heard = new ArrayList<>();
        document.addListener(change -> heard.add(change.elements("clv")));
        String place = document.plan("clv").orElseThrow().places().get(0).id();

        document.apply(new VertexEdit.NameVertex("clv", place, "Another name"));
        document.undo();

        assertThat(heard).containsExactly(Set.of(place), Set.of(place));
    }

    @Test
    void anEditThatIsRefusedIsToldToNobody() {
        List<DocumentChange> heard = new ArrayList<>();
        document.addListener(heard::add);

        document.apply(new ProjectEdit.RenamePlan("clv", "station-keep"));
        document.apply(new ProjectEdit.NameProject(document.project().name()));

        assertThat(heard).isEmpty();
        assertThat(document.isModified()).isFalse();
    }
}
