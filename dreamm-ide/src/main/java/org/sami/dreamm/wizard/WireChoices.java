package org.sami.dreamm.wizard;

import java.awt.Component;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.dreamm.profile.ProfileGuard;
import org.sami.spn.vocabulary.Vocabulary;
import org.sami.spn.wiring.DataSource;
import org.sami.spn.wiring.FieldProposal;
import org.sami.spn.wiring.SourceWords;
import org.sami.ui.look.Spacing;
import org.sami.ui.value.ValueField;

/** One line for each field of an event that is added and could be read from something: from what, nearest first. */
final class WireChoices extends JPanel {
    private static final String OPEN = "– left open –";

    private final transient Vocabulary vocabulary;

    WireChoices(Vocabulary vocabulary) {
        super(new MigLayout("novisualpadding, insets 0, gap 8 0, wrap 2, fillx", "[pref!, left][grow, fill]"));
        this.vocabulary = vocabulary;
        setName("wizard-wires");
        setOpaque(false);
    }

    /** Shows the fields that an addition reads or that are required. */
    void show(
            List<FieldProposal> proposals,
            Map<String, Optional<DataSource>> chosen,
            BiConsumer<String, Optional<DataSource>> choose) {
        removeAll();
        for (FieldProposal proposal : proposals) {
            String field = proposal.field().name();
            if (proposal.proposed().isPresent() || proposal.field().required() || chosen.containsKey(field)) {
                Optional<DataSource> now = chosen.getOrDefault(field, proposal.proposed());
                add(new JLabel(ValueField.words(field) + " from"));
                add(box(proposal, now, source -> choose.accept(field, source)), "wmin 0, hmin " + Spacing.HIT_TARGET);
            }
        }
        setVisible(getComponentCount() > 0);
    }

    private JComboBox<Optional<DataSource>> box(
            FieldProposal proposal, Optional<DataSource> now, Consumer<Optional<DataSource>> given) {
        JComboBox<Optional<DataSource>> box = new JComboBox<>();
        List<Optional<DataSource>> options = new ArrayList<>();
        proposal.sources().forEach(s -> options.add(Optional.of(s)));
        options.add(Optional.empty());
        options.forEach(box::addItem);
        box.setSelectedItem(now);
        box.setName("wizard-wire-" + kebab(proposal.field().name()));
        box.getAccessibleContext()
                .setAccessibleName(ValueField.words(proposal.field().name()) + " is read from");
        box.setToolTipText(now.map(this::words).orElse(OPEN));
        ProfileGuard.mark(box, "event-field-source");
        box.setRenderer(new DefaultListCellRenderer() {
            @Override
            @SuppressWarnings("unchecked")
            public Component getListCellRendererComponent(
                    JList<?> list, Object value, int index, boolean selected, boolean focus) {
                String text = value == null
                        ? OPEN
                        : ((Optional<DataSource>) value)
                                .map(s -> index < 0 ? SourceWords.brief(s, vocabulary) : words(s))
                                .orElse(OPEN);
                return super.getListCellRendererComponent(list, text, index, selected, focus);
            }
        });
        box.addActionListener(e -> {
            Optional<DataSource> chosen = box.getItemAt(box.getSelectedIndex());
            if (!chosen.equals(now)) {
                given.accept(chosen);
            }
        });
        return box;
    }

    private String words(DataSource source) {
        return SourceWords.of(source, vocabulary);
    }

    private static String kebab(String field) {
        return field.replaceAll("([a-z0-9])([A-Z])", "$1-$2").toLowerCase(Locale.ROOT);
    }
}
