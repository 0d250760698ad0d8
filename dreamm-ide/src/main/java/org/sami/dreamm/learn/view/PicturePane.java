package org.sami.dreamm.learn.view;

import java.awt.Dimension;
import java.awt.event.MouseWheelEvent;
import javax.swing.BorderFactory;
import javax.swing.JScrollPane;
import javax.swing.SwingUtilities;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;

/** A frame around a picture: as high as it, with a scroll bar where it is wider than the column. The wheel scrolls the column. */
final class PicturePane extends JScrollPane {
    private final PictureView picture;

    PicturePane(PictureView picture) {
        super(picture, VERTICAL_SCROLLBAR_NEVER, HORIZONTAL_SCROLLBAR_AS_NEEDED);
        this.picture = picture;
        setName("learn-picture-pane");
        LookColors.border(this, () -> BorderFactory.createLineBorder(SemanticColor.BORDER.get(), Look.px(1)));
        getHorizontalScrollBar().setUnitIncrement(Look.px(24));
    }

    @Override
    public Dimension getPreferredSize() {
        int frame = 2 * Look.px(1);
        getViewport()
                .setSize(
                        Math.max(1, getWidth() - frame),
                        Math.max(1, getViewport().getHeight()));
        Dimension net = picture.getPreferredSize();
        int bar = net.width > getWidth() - frame ? getHorizontalScrollBar().getPreferredSize().height : 0;
        return new Dimension(getWidth(), net.height + frame + bar);
    }

    @Override
    protected void processMouseWheelEvent(MouseWheelEvent e) {
        if (getParent() != null) {
            getParent().dispatchEvent(SwingUtilities.convertMouseEvent(this, e, getParent()));
        }
    }
}
