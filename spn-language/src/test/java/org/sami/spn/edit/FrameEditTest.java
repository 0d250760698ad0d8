package org.sami.spn.edit;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.sami.spn.model.FrameColor;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.NetFrame;
import org.sami.spn.model.Project;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.TestVocabulary;

class FrameEditTest {
    private static final NetFrame ONE = new NetFrame("one", FrameColor.BLUE, new LayoutPoint(0, 0), 100, 80);
    private static final NetFrame TWO = new NetFrame("two", FrameColor.SAND, new LayoutPoint(200, 0), 50, 40);

    private final Project project =
            NetBuilder.project(new NetBuilder("p").start("s").build().withFrames(List.of(ONE, TWO)));

    private List<NetFrame> after(Edit edit) {
        return edit.apply(project, TestVocabulary.TEST)
                .project()
                .orElseThrow()
                .plan("p")
                .orElseThrow()
                .frames();
    }

    @Test
    void aFrameGetsAnotherPlaceSizeAndTitle() {
        LayoutPoint there = new LayoutPoint(3, 4);

        assertThat(after(new FrameEdit.MoveFrames("p", Map.of(1, there)))).containsExactly(ONE, TWO.withAt(there));
        assertThat(after(new FrameEdit.SetFrame("p", 0, ONE.withTitle("first").withSize(9, 8))))
                .containsExactly(new NetFrame("first", FrameColor.BLUE, ONE.at(), 9, 8), TWO);
        assertThat(after(new FrameEdit.AddFrame("p", ONE))).containsExactly(ONE, TWO, ONE);
    }

    @Test
    void severalAreRemovedByTheIndicesThatTheyHadBefore() {
        assertThat(after(new FrameEdit.RemoveFrames("p", Set.of(0, 1)))).isEmpty();
        assertThat(after(new FrameEdit.RemoveFrames("p", Set.of(0)))).containsExactly(TWO);
    }

    @Test
    void oneThatIsNotThereOrLiesNowhereIsRefused() {
        assertThat(new FrameEdit.SetFrame("p", 2, ONE).apply(project, TestVocabulary.TEST))
                .isEqualTo(new EditResult.Refused("The plan \"p\" has no frame 3"));
        assertThat(new FrameEdit.MoveFrames("p", Map.of(0, new LayoutPoint(Double.NaN, 0)))
                        .apply(project, TestVocabulary.TEST))
                .isInstanceOf(EditResult.Refused.class);
    }
}
