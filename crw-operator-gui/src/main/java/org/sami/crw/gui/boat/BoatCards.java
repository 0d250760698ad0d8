package org.sami.crw.gui.boat;

import java.awt.BorderLayout;
import java.awt.Rectangle;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import javax.swing.AbstractListModel;
import javax.swing.BorderFactory;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import javax.swing.ScrollPaneConstants;
import org.jspecify.annotations.Nullable;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.gui.picture.PictureChoice;
import org.sami.crw.gui.picture.ShownPictures;
import org.sami.palette.SemanticColor;
import org.sami.ui.command.Command;
import org.sami.ui.look.Look;

/** The boats as cards, each with its newest picture; a press on the picture, or Enter, shows it large. The selection is the session's. */
final class BoatCards extends JPanel {
    private final OperatorContext context;
    private final ShownPictures pictures;
    private final Cards cards = new Cards();
    private final JList<BoatCard> list = new Boxes(cards);
    private final Command enlarge;
    private boolean filling;

    private static final class Cards extends AbstractListModel<BoatCard> {
        private List<BoatCard> all = List.of();

        @Override
        public int getSize() {
            return all.size();
        }

        @Override
        public BoatCard getElementAt(int index) {
            return all.get(index);
        }

        void show(List<BoatCard> now) {
            int before = all.size();
            all = List.copyOf(now);
            if (before > all.size()) {
                fireIntervalRemoved(this, all.size(), before - 1);
            } else if (before < all.size()) {
                fireIntervalAdded(this, before, all.size() - 1);
            }
            if (!all.isEmpty()) {
                fireContentsChanged(this, 0, all.size() - 1);
            }
        }
    }

    private static final class Boxes extends JList<BoatCard> {
        Boxes(Cards cards) {
            super(cards);
        }

        @Override
        public boolean getScrollableTracksViewportWidth() {
            return true;
        }

        @Override
        public @Nullable String getToolTipText(MouseEvent event) {
            int index = locationToIndex(event.getPoint());
            return index < 0 ? null : getModel().getElementAt(index).state();
        }

        @Override
        public void updateUI() {
            super.updateUI();
            setBackground(SemanticColor.SURFACE.get());
            setFixedCellHeight(BoatCardView.height());
        }
    }

    BoatCards(OperatorContext context, ShownPictures pictures) {
        super(new BorderLayout());
        this.context = context;
        this.pictures = pictures;
        list.setName("boat-cards");
        list.getAccessibleContext().setAccessibleName(context.say("Boats with their newest pictures"));
        BoatCardView view = new BoatCardView(context, pictures);
        list.setCellRenderer(
                (of, card, index, selected, focused) -> view.of(card, selected, focused && of.isFocusOwner()));
        list.addListSelectionListener(e -> {
            if (!filling && !e.getValueIsAdjusting()) {
                context.boats()
                        .select(list.getSelectedValuesList().stream()
                                .filter(BoatCard::known)
                                .map(BoatCard::name)
                                .toList());
            }
        });
        context.boats().addListener(this::select);
        pictures.addListener(list::repaint);
        enlarge = context.commands()
                .add(new Command("boat-picture", "Newest picture of the selected boat", this::enlarge)
                        .withKey("alt shift O")
                        .withIcon("picture")
                        .unless(() -> picture().isPresent()
                                ? Optional.empty()
                                : Optional.of("select a boat that has taken a picture")));
        list.getInputMap().put(KeyStroke.getKeyStroke("ENTER"), enlarge.id());
        list.getActionMap().put(enlarge.id(), enlarge);
        list.addMouseListener(new MouseAdapter() {
            @Override
            public void mouseClicked(MouseEvent e) {
                pressed(e);
            }
        });
        JScrollPane scroll = new JScrollPane(
                list, ScrollPaneConstants.VERTICAL_SCROLLBAR_AS_NEEDED, ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
        scroll.setBorder(BorderFactory.createEmptyBorder());
        scroll.getVerticalScrollBar().setUnitIncrement(Look.px(16));
        add(scroll);
    }

    private void pressed(MouseEvent e) {
        int index = list.locationToIndex(e.getPoint());
        Rectangle cell = index < 0 ? null : list.getCellBounds(index, index);
        if (cell != null && cell.contains(e.getPoint())) {
            Rectangle picture = BoatCardView.picture(cell.width);
            picture.translate(cell.x, cell.y);
            if (picture.contains(e.getPoint())) {
                pictures.newest(cards.getElementAt(index).name()).ifPresent(pictures::open);
            }
        }
    }

    private Optional<PictureChoice> picture() {
        List<String> boats = context.boats().boats();
        return boats.isEmpty() ? Optional.empty() : pictures.newest(boats.get(0));
    }

    private void enlarge() {
        picture().ifPresent(pictures::open);
    }

    /** Shows these, in this order. */
    void show(List<BoatCard> now) {
        if (!now.equals(cards.all)) {
            filling = true;
            cards.show(now);
            filling = false;
            select();
        }
    }

    /** Selects what the session has selected. */
    private void select() {
        Set<String> wanted = new HashSet<>(context.boats().boats());
        int[] indices = new int[cards.getSize()];
        int some = 0;
        for (int i = 0; i < cards.getSize(); i++) {
            if (wanted.contains(cards.getElementAt(i).name())) {
                indices[some++] = i;
            }
        }
        filling = true;
        list.setSelectedIndices(Arrays.copyOf(indices, some));
        filling = false;
        enlarge.refresh();
    }
}
