package org.sami.dreamm.wizard;

import java.awt.event.ActionEvent;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.swing.AbstractAction;
import javax.swing.ButtonGroup;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JRadioButton;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.sami.dreamm.profile.ProfileGuard;
import org.sami.palette.SemanticColor;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.FreshIds;
import org.sami.spn.sequence.Sequence;
import org.sami.spn.wiring.DataSource;
import org.sami.spn.wiring.Wires;
import org.sami.spn.wizard.AddEvent;
import org.sami.spn.wizard.EventTarget;
import org.sami.spn.wizard.PlanChange;
import org.sami.ui.look.Fonts;
import org.sami.ui.value.WrappedText;

/**
 * Says what the marked item of a palette is, offers the sequences of an event, and says what would be drawn. After an event was added the
 * same strip lets another of its sequences take the place of the one that came with it.
 */
public final class SequenceStrip extends JPanel {
    private final transient Additions additions;
    private final JLabel title = new JLabel();
    private final WrappedText help = new WrappedText("");
    private final JPanel choices =
            new JPanel(new MigLayout("novisualpadding, insets 0, gap 0 0, wrap 1", "[grow, fill]"));
    private final WireChoices reading;
    private final WrappedText preview = new WrappedText("");
    private Optional<Edit> offered = Optional.empty();
    private String sequence = "";
    private String event = "";
    private EventTarget target = new EventTarget.Free(Optional.empty());
    private Map<String, Optional<DataSource>> read = Map.of();

    /** A strip over the additions of a window. */
    public SequenceStrip(Additions additions) {
        super(new MigLayout("novisualpadding, insets 0, gap 0 4, wrap 1, fillx, hidemode 3", "[grow, fill]"));
        this.additions = additions;
        this.reading = new WireChoices(additions.vocabulary());
        setName("wizard-strip");
        setOpaque(false);
        choices.setOpaque(false);
        help.setColor(SemanticColor.MUTED);
        preview.setName("wizard-preview");
        title.setName("wizard-title");
        add(title, "wmin 0");
        add(help, "wmin 0");
        add(choices, "wmin 0");
        add(reading, "wmin 0");
        add(preview, "wmin 0");
    }

    /** Adds what is shown when Enter is pressed at a choice of the strip. */
    public void whenConfirmed(Runnable confirmed) {
        getInputMap(WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke("ENTER"), "add");
        getActionMap().put("add", new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent e) {
                confirmed.run();
            }
        });
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (title != null) {
            title.setFont(Fonts.strong());
        }
    }

    /**
     * Shows what an item is and what would come with it.
     *
     * @param edit what adds it where it would go now; empty where nothing is marked, or it cannot go there
     * @param refusal why it cannot go there
     */
    public void show(String label, String text, Optional<Edit> edit, Optional<String> refusal) {
        title.setFont(Fonts.strong());
        Optional<AddEvent> last = additions.last();
        offered = edit;
        boolean added = last.isPresent()
                && (edit.isEmpty()
                        || (edit.get() instanceof AddEvent marked
                                && marked.event().equals(last.get().event())));
        title.setText(label.isEmpty() ? "Nothing is marked" : label);
        help.setText(
                label.isEmpty()
                        ? "Mark an item to see what it does; drag it onto the net, or press Enter to add it to what is selected."
                        : text);
        choices.removeAll();
        Optional<AddEvent> of =
                added ? last : edit.filter(AddEvent.class::isInstance).map(AddEvent.class::cast);
        of.ifPresent(e -> offer(e, added));
        of.ifPresentOrElse(e -> offerReading(e, added), () -> reading.show(List.of(), Map.of(), (field, source) -> {}));
        if (added) {
            preview.setText(
                    additions.addsAlone()
                            ? "Added. Undo takes it back."
                            : "Added. Choose another sequence to exchange it, or undo.");
        } else {
            preview.setText(
                    refusal.orElseGet(() -> edit.map(e -> words(chosen(e))).orElse("")));
        }
        revalidate();
        repaint();
    }

    /** From where the fields of the event are read, nearest first; another choice after the addition exchanges it. */
    private void offerReading(AddEvent edit, boolean added) {
        reading.show(
                additions.proposals(added ? edit : edit.withSequence(sequence)),
                added ? edit.wires().chosen() : read,
                (field, source) -> {
                    if (added) {
                        additions.exchange(e -> e.withWires(e.wires().with(field, source)));
                    } else {
                        Map<String, Optional<DataSource>> more = new LinkedHashMap<>(read);
                        more.put(field, source);
                        read = more;
                    }
                });
    }

    private void offer(AddEvent edit, boolean added) {
        if (!edit.event().equals(event) || !edit.target().equals(target)) {
            read = Map.of();
        }
        target = edit.target();
        if (!edit.event().equals(event)) {
            event = edit.event();
            sequence = edit.sequence();
        }
        if (added) {
            sequence = edit.sequence();
        }
        ButtonGroup group = new ButtonGroup();
        for (Sequence each : additions.library().of(edit.event())) {
            choices.add(
                    button(
                            group,
                            each.id(),
                            each.name(),
                            each.isManual() ? "manual" : "flexible",
                            each.isManual() ? each.help() + " Its edges are locked." : each.help(),
                            added),
                    "wmin 0");
        }
        choices.add(
                button(
                        group,
                        Sequence.ALONE,
                        "The event alone",
                        "",
                        "Adds nothing else; requirements are adjusted",
                        added),
                "wmin 0");
    }

    private JRadioButton button(ButtonGroup group, String id, String name, String kind, String tip, boolean added) {
        JRadioButton button = new JRadioButton(kind.isEmpty() ? name : name + "  (" + kind + ")", id.equals(sequence));
        button.setName("wizard-sequence-" + FreshIds.ofWords(id));
        ProfileGuard.mark(button, "wizard-sequence");
        button.setToolTipText(tip.isEmpty() ? button.getText() : tip);
        button.setOpaque(false);
        button.addActionListener(e -> {
            sequence = id;
            if (added) {
                additions.exchange(last -> last.withSequence(id));
            } else {
                preview.setText(offered.map(o -> words(chosen(o))).orElse(""));
            }
        });
        group.add(button);
        return button;
    }

    /** The edit with the sequence that is chosen here. */
    public Edit chosen(Edit edit) {
        if (!(edit instanceof AddEvent add) || !add.event().equals(event) || sequence.isEmpty()) {
            return edit;
        }
        Wires wires = add.wires();
        for (Map.Entry<String, Optional<DataSource>> field : read.entrySet()) {
            wires = wires.with(field.getKey(), field.getValue());
        }
        return add.withSequence(sequence).withWires(wires);
    }

    private String words(Edit edit) {
        Additions.Preview shown = additions.preview(edit);
        if (shown.refusal().isPresent()) {
            return shown.refusal().get();
        }
        String lines = shown.change().map(c -> String.join("\n", c.lines())).orElse("");
        preview.setToolTipText(lines.isEmpty() ? null : lines);
        String where = edit instanceof AddEvent add ? where(add.target()) : "";
        return where + shown.change().map(PlanChange::summary).orElse("");
    }

    private String where(EventTarget target) {
        if (target instanceof EventTarget.OnVertex on) {
            return "Enter adds it to " + additions.vertexName(on.vertex()) + ". ";
        }
        return target instanceof EventTarget.Behind behind
                ? "Enter adds it behind " + additions.vertexName(behind.vertex()) + ". "
                : "Enter adds it as a vertex of its own. ";
    }
}
