package org.sami.ui.look;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.BorderLayout;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JLabel;
import org.junit.jupiter.api.Test;

class FoldingPanelTest {
    private final FoldingPanel panel = new FoldingPanel(new BorderLayout());
    private final List<String> heard = new ArrayList<>();

    private void layOut(int width, int height) {
        panel.setSize(width, height);
        panel.doLayout();
    }

    @Test
    void eachFoldChangesOnceOnEachSideOfItsLimit() {
        panel.foldBelowWidth(400, narrow -> heard.add("narrow " + narrow));
        panel.foldBelowHeight(200, low -> heard.add("low " + low));

        layOut(Look.px(400), Look.px(200));
        assertThat(heard).isEmpty();

        layOut(Look.px(399), Look.px(200));
        layOut(Look.px(300), Look.px(199));
        layOut(Look.px(300), Look.px(100));
        layOut(Look.px(500), Look.px(100));

        assertThat(heard).containsExactly("narrow true", "low true", "narrow false");
    }

    @Test
    void nothingFoldsBeforeThereIsASize() {
        FoldingPanel.Fold fold = panel.foldBelowHeight(200, low -> heard.add("low"));

        layOut(0, 0);

        assertThat(fold.isFolded()).isFalse();
        assertThat(heard).isEmpty();
    }

    @Test
    void whatAFoldHidesLeavesItsRoomInTheSameLayout() {
        JLabel head = new JLabel("head");
        JLabel body = new JLabel("body");
        panel.add(head, BorderLayout.NORTH);
        panel.add(body);
        FoldingPanel.Fold low = panel.foldBelowHeight(200, folded -> head.setVisible(!folded));
        layOut(Look.px(300), Look.px(300));
        int below = body.getY();

        layOut(Look.px(300), Look.px(150));

        assertThat(below).isPositive();
        assertThat(low.isFolded()).isTrue();
        assertThat(body.getY()).isZero();
        assertThat(body.getHeight()).isEqualTo(Look.px(150));
    }
}
