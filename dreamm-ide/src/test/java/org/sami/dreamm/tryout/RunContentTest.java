package org.sami.dreamm.tryout;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.ProjectEdit;
import org.sami.spn.edit.RemoveElements;
import org.sami.spn.edit.VertexEdit;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Project;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.TestVocabulary;

class RunContentTest {
    private static final Project PROJECT =
            NetBuilder.project(plan("p").build(), plan("q").build());

    private static NetBuilder plan(String id) {
        return new NetBuilder(id)
                .start("start")
                .end("end")
                .in("start", "go", "any >= 1")
                .out("go", "end", "take all any");
    }

    private static boolean isSameAfter(Edit edit) {
        Project after = edit.apply(PROJECT, TestVocabulary.TEST).project().orElseThrow();
        assertThat(after).isNotEqualTo(PROJECT);
        return RunContent.of(PROJECT, "p").equals(RunContent.of(after, "p"));
    }

    @Test
    void layoutDescriptionsAndOtherPlansAreNoPartOfIt() {
        assertThat(isSameAfter(new VertexEdit.MoveVertices("p", Map.of("start", new LayoutPoint(70, 7)))))
                .isTrue();
        assertThat(isSameAfter(new ProjectEdit.DescribePlan("p", "Plan", "What it is for", List.of())))
                .isTrue();
        assertThat(isSameAfter(new RemoveElements("q", Set.of("go")))).isTrue();
    }

    @Test
    void edgesRequirementsAndNamesThatFindingsSayAreAPartOfIt() {
        String edge = PROJECT.plan("p").orElseThrow().inEdges().get(0).id();

        assertThat(isSameAfter(new RemoveElements("p", Set.of(edge)))).isFalse();
        assertThat(isSameAfter(new VertexEdit.NameVertex("p", "start", "Harbour")))
                .isFalse();
        assertThat(isSameAfter(new VertexEdit.SetEnd("p", "end", false, false))).isFalse();
    }

    @Test
    void resultsThatWereUsedLongAgoAreForgottenFirst() {
        KeptResults<String, Integer> kept = new KeptResults<>(2);
        kept.keep("a", 1);
        kept.keep("b", 2);
        assertThat(kept.find("a")).contains(1);
        kept.keep("c", 3);

        assertThat(kept.find("a")).contains(1);
        assertThat(kept.find("b")).isEmpty();
        assertThat(kept.find("c")).contains(3);
    }
}
