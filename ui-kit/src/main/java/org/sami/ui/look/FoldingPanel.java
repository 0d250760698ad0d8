package org.sami.ui.look;

import java.awt.LayoutManager;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import javax.swing.JPanel;

/**
 * A panel that folds by its size: parts of it have one form where there is room, and another where the panel is narrower or lower than a
 * limit. Limits are pixels at 100 % and follow the scale. A fold changes before the layout of the panel, and only when the panel comes to the
 * other side of the limit. Nothing is folded before the panel has a size. For the event thread.
 */
public class FoldingPanel extends JPanel {
    private final transient List<Fold> folds = new ArrayList<>();

    /** One of its folds. */
    public static final class Fold {
        private final BooleanSupplier condition;
        private final Consumer<Boolean> change;
        private boolean folded;

        private Fold(BooleanSupplier condition, Consumer<Boolean> change) {
            this.condition = condition;
            this.change = change;
        }

        /** Whether it is folded, as of the last layout. */
        public boolean isFolded() {
            return folded;
        }

        private void look() {
            boolean now = condition.getAsBoolean();
            if (now != folded) {
                folded = now;
                change.accept(now);
            }
        }
    }

    /** A panel without folds. */
    public FoldingPanel(LayoutManager layout) {
        super(layout);
    }

    /**
     * Adds a fold for the width.
     *
     * @param limit the panel is folded where it is narrower
     * @param change receives true when it folds, false when it unfolds
     */
    public final Fold foldBelowWidth(int limit, Consumer<Boolean> change) {
        return foldWhere(() -> getWidth() < Look.px(limit), change);
    }

    /**
     * Adds a fold for the height.
     *
     * @param limit the panel is folded where it is lower
     * @param change receives true when it folds, false when it unfolds
     */
    public final Fold foldBelowHeight(int limit, Consumer<Boolean> change) {
        return foldWhere(() -> getHeight() < Look.px(limit), change);
    }

    /**
     * Adds a fold for which more than one limit counts; folds are looked at in the order in which they were added.
     *
     * @param condition is looked at before each layout
     * @param change receives true when it folds, false when it unfolds
     */
    public final Fold foldWhere(BooleanSupplier condition, Consumer<Boolean> change) {
        Fold fold = new Fold(condition, change);
        folds.add(fold);
        return fold;
    }

    @Override
    public void doLayout() {
        if (getWidth() > 0 && getHeight() > 0) {
            folds.forEach(Fold::look);
        }
        super.doLayout();
    }
}
