package org.sami.ui.map;

import java.awt.Dimension;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;
import org.sami.palette.SemanticColor;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.geo.CoordinateNotation;
import org.sami.ui.geo.Coordinates;
import org.sami.ui.look.FoldingPanel;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Icons;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.Spacing;

/** The strip below a map: coordinates under the pointer, their notation, a field to type some, what to do, and zoom. */
final class MapStatusBar extends FoldingPanel {
    private static final String HEIGHT = "hmin " + Spacing.HIT_TARGET_FIELD + ", wmin " + Spacing.HIT_TARGET_FIELD;
    private static final int WIDE_PX = 860;
    private static final GeoPoint LONGEST = GeoPoint.of(-88.888888, -178.888888);

    private final JButton coordinates = new JButton("Pointer: –");
    private final JComboBox<CoordinateNotation> notations = new JComboBox<>(CoordinateNotation.values());
    private final JTextField field = new JTextField(18);
    private final transient BiConsumer<String, Boolean> says;
    private Optional<GeoPoint> last = Optional.empty();

    MapStatusBar(Consumer<MapKey> keys, Consumer<GeoPoint> typed, Runnable copy, BiConsumer<String, Boolean> says) {
        super(new MigLayout("insets 2 6 2 6, gap 4, hidemode 3", "[][][]push[][][][]", "[]"));
        this.says = says;
        setName("map-status");
        coordinates.setName("map-coordinates");
        coordinates.setToolTipText(
                "Coordinates under the pointer. A click copies them, as does " + MapKey.COPY.keyText());
        coordinates.setHorizontalAlignment(JButton.LEFT);
        coordinates.putClientProperty("JButton.buttonType", "toolBarButton");
        coordinates.addActionListener(e -> copy.run());
        notations.setName("map-notation");
        notations.setToolTipText("How coordinates are written");
        notations.getAccessibleContext().setAccessibleName("Notation of coordinates");
        notations.setRenderer((list, value, index, selected, focused) -> {
            JLabel label = new JLabel(value == null ? "" : value.label());
            label.setOpaque(selected);
            LookColors.background(label, SemanticColor.SELECTION);
            LookColors.foreground(label, selected ? SemanticColor.ON_SELECTION : SemanticColor.TEXT);
            return label;
        });
        notations.addActionListener(e -> showLast());
        field.setName("map-type-coordinates");
        field.setToolTipText(
                "Type coordinates and press Enter: " + Coordinates.EXAMPLES + " (" + MapKey.TYPE.keyText() + ")");
        field.getAccessibleContext().setAccessibleName("Coordinates to go to or to add");
        field.putClientProperty("JTextField.placeholderText", "Type coordinates");
        field.addActionListener(e -> enter(typed));
        reserve();
        foldBelowWidth(WIDE_PX, this::leaveOutTyping);
        add(coordinates, HEIGHT);
        add(notations, HEIGHT);
        add(field, HEIGHT);
        add(button(MapKey.MEASURE, "measure", keys), HEIGHT);
        add(button(MapKey.FIT, "fit", keys), HEIGHT);
        add(button(MapKey.ZOOM_OUT, "zoom-out", keys), HEIGHT);
        add(button(MapKey.ZOOM_IN, "zoom-in", keys), HEIGHT);
    }

    private static JButton button(MapKey key, String icon, Consumer<MapKey> keys) {
        JButton button = new JButton(Icons.normal(icon));
        button.putClientProperty("JButton.buttonType", "toolBarButton");
        button.setName(key.id());
        button.setToolTipText(key.label() + " (" + key.keyText() + ")");
        button.getAccessibleContext().setAccessibleName(key.label());
        button.setFocusable(true);
        button.addActionListener(e -> keys.accept(key));
        return button;
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (coordinates != null) {
            reserve();
        }
    }

    /** Keeps room for the longest coordinates, so that nothing jumps. */
    private void reserve() {
        String shown = coordinates.getText();
        coordinates.setFont(Fonts.text());
        coordinates.setPreferredSize(null);
        coordinates.setText(notation().format(LONGEST));
        Dimension size = coordinates.getPreferredSize();
        coordinates.setText(shown);
        coordinates.setPreferredSize(size);
        coordinates.setMinimumSize(size);
        revalidate();
    }

    private void enter(Consumer<GeoPoint> typed) {
        Optional<GeoPoint> point = Coordinates.parse(field.getText());
        if (point.isPresent()) {
            field.setText("");
            field.putClientProperty("JComponent.outline", null);
            says.accept("", false);
            typed.accept(point.get());
        } else {
            field.putClientProperty("JComponent.outline", "error");
            says.accept("'" + field.getText() + "' are no coordinates; type " + Coordinates.EXAMPLES, true);
        }
    }

    CoordinateNotation notation() {
        return (CoordinateNotation) notations.getSelectedItem();
    }

    void setNotation(CoordinateNotation notation) {
        notations.setSelectedItem(notation);
    }

    /** Where the pointer was last. */
    Optional<GeoPoint> last() {
        return last;
    }

    /** On a narrow map only what is needed most has room; typing makes some. */
    private void leaveOutTyping(boolean narrow) {
        notations.setVisible(!narrow);
        field.setVisible(!narrow);
    }

    /** Puts the focus into the field. */
    void type() {
        field.setVisible(true);
        field.requestFocusInWindow();
        field.selectAll();
    }

    /** Shows where the pointer is. */
    void point(Optional<GeoPoint> at) {
        last = at.or(() -> last);
        showLast();
    }

    private void showLast() {
        coordinates.setText(last.map(notation()::format).orElse("Pointer: –"));
        reserve();
    }
}
