package org.sami.dreamm.canvas;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.context.NetOverlay;
import org.sami.dreamm.context.NetPreview;
import org.sami.dreamm.document.DocumentChange;
import org.sami.dreamm.document.EditorListener;
import org.sami.dreamm.help.word.ShownText;
import org.sami.dreamm.help.word.TermSource;
import org.sami.dreamm.profile.ProfileIds;
import org.sami.palette.ProxyMarks;
import org.sami.palette.SemanticColor;
import org.sami.picture.NetFonts;
import org.sami.picture.net.NetMarking;
import org.sami.spn.drawing.NetDetail;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.drawing.NetDrawing.Edge;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Plan;
import org.sami.ui.command.Command;
import org.sami.ui.net.NetListener;
import org.sami.ui.net.NetView;
import org.sami.ui.value.WrappedText;

/** The net of the open plan, as its author sees and changes it (thesis 5.1). */
public final class ModelView extends JPanel implements NetDropTarget, TermSource {
    private static final double REACH_PX = 4;
    private static final String[] MENU = {
        "net-rename",
        "net-append",
        "net-connect",
        "",
        "net-set-start",
        "net-set-end",
        "net-mark-recovery",
        "net-mark-nominal",
        "net-disable",
        "net-extract",
        "",
        "net-cut",
        "net-copy",
        "net-paste-here",
        "net-duplicate",
        "net-delete",
        "",
        "net-add-place",
        "net-add-transition",
        "net-add-note",
        "net-add-frame"
    };

    private final transient DreammContext context;
    private final NetView view = new NetView(new ProxyMarks());
    private final WrappedText hint = new WrappedText("");
    private final transient ShownNet net;
    private final transient NetActions actions;
    private transient NetMarking marking = NetMarking.EMPTY;
    private boolean tokens = true;

    /** The view of a window, which registers its commands. */
    public ModelView(DreammContext context) {
        super(new BorderLayout());
        this.context = context;
        setName("model-view");
        net = new ShownNet(context.vocabulary(), NetFonts::width);
        if (!context.profile().shows(ProfileIds.MISSING_REQUIREMENT)) {
            net.setDetail(NetDetail.READER);
        }
        if (!context.profile().shows(ProfileIds.EDGE)) {
            net.setDetail(net.detail().withRequirements(false));
        }
        actions = new NetActions(context, view, net);
        context.typed().add(actions::endWriting);
        Connecting connecting = new Connecting(view, net, actions);
        EditTool tool = new EditTool(view, net, actions, connecting);
        view.setTool(tool);
        view.canvas().setTransferHandler(new NetDropHandler(view, net, actions));
        view.canvas().setFocusTraversalKeysEnabled(false); // Tab goes through the vertices; F6 leaves
        actions.setMenu(this::menu);
        new CanvasViewCommands(context, view, new ShownDetail()).add();
        LayoutCommands layouts = new LayoutCommands(context, view, net, actions);
        layouts.add();
        new CanvasCommands(context, view, net, actions, tool, connecting, layouts::cancel).add();
        hint.setName("net-empty");
        hint.setColor(SemanticColor.MUTED);
        JPanel top = new JPanel(new BorderLayout());
        top.add(ModelTools.of(context), BorderLayout.NORTH);
        JPanel hintPlace =
                new JPanel(new MigLayout("novisualpadding, hidemode 3, fillx, insets 0 12 0 12", "[grow, fill]"));
        hintPlace.add(hint, "wmin 0, gapbottom 8");
        top.add(hintPlace);
        add(top, BorderLayout.NORTH);
        add(view);
        view.canvas().addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                if (tool.pointer().isEmpty()) { // nobody has looked elsewhere yet
                    view.fit();
                }
            }
        });
        listen();
        showPlan();
        view.setMode(context.editor().mode());
    }

    private final class ShownDetail implements CanvasViewCommands.Detail {
        @Override
        public NetDetail get() {
            return net.detail();
        }

        @Override
        public void set(NetDetail detail) {
            net.setDetail(detail);
            view.show(net.plan(), context.vocabulary(), net.drawing());
        }

        @Override
        public void toggleTokens() {
            tokens = !tokens;
            showMarking(marking);
        }
    }

    private void listen() {
        context.document().addListener(this::documentChanged);
        context.editor().addListener(new EditorListener() {
            @Override
            public void planOpened() {
                showPlan();
            }

            @Override
            public void modeChanged() {
                view.setMode(context.editor().mode());
                context.commands().refresh();
            }

            @Override
            public void selectionChanged() {
                view.select(context.editor().selection());
            }

            @Override
            public void highlightChanged() {
                view.highlight(context.editor().highlight());
            }
        });
        context.overlay().addListener(new NetOverlay.Listener() {
            @Override
            public void changed() {
                showOverlay();
            }

            @Override
            public void fired(List<String> transitions) {
                transitions.forEach(view::fired);
            }
        });
        context.preview().addListener(this::showPreview);
        context.additions().addAddedListener(view::revealWhole);
        view.addNetListener(new NetListener() {
            @Override
            public void selected(Set<String> ids) {
                if (!ids.equals(context.editor().selection())) {
                    context.editor().select(ids);
                }
            }
        });
    }

    private void documentChanged(DocumentChange change) {
        if (change.isOpened()) {
            net.forget();
        }
        if (change.isOpened() || change.plans().contains(net.plan().id())) {
            NetDrawing before = net.drawing();
            showPlan();
            if (isBackOrForth(change) && isMostElsewhere(before)) {
                view.fit();
            }
        }
    }

    private static boolean isBackOrForth(DocumentChange change) {
        return change.cause() == DocumentChange.Cause.UNDONE || change.cause() == DocumentChange.Cause.REDONE;
    }

    /** Whether half of the vertices or more lie elsewhere now, as when a layout is taken back. */
    private boolean isMostElsewhere(NetDrawing before) {
        Map<String, LayoutPoint> places = new HashMap<>();
        before.vertices().forEach(vertex -> places.put(vertex.id(), vertex.centre()));
        List<Vertex> now = net.drawing().vertices();
        long moved = now.stream()
                .filter(vertex -> isElsewhere(places.get(vertex.id()), vertex.centre()))
                .count();
        return moved > 1 && 2 * moved >= now.size();
    }

    private static boolean isElsewhere(@Nullable LayoutPoint before, LayoutPoint now) {
        return before != null && Math.hypot(before.x() - now.x(), before.y() - now.y()) > 1;
    }

    private void showOverlay() {
        showMarking(context.overlay().shown().marking());
        view.setBadges(context.overlay().shown().badges());
        view.setExplanation(context.overlay().shown().why());
    }

    private void showPlan() {
        actions.endWriting();
        net.show(context.editor().plan());
        boolean empty = context.editor()
                .plan()
                .filter(plan -> plan.places().isEmpty() && plan.transitions().isEmpty())
                .isPresent();
        hint.setText(empty ? emptyText() : "");
        hint.setVisible(empty);
        view.show(net.plan(), context.vocabulary(), net.drawing());
        view.select(context.editor().selection());
    }

    /** Shows the plan as it would be after an edit that the author thinks about, or as it is. */
    private void showPreview() {
        Optional<NetPreview.Shown> preview = context.preview().shown();
        view.setChanges(preview.map(NetPreview.Shown::changes).orElse(Map.of()));
        if (preview.isEmpty()) {
            showPlan();
            return;
        }
        actions.endWriting();
        Plan planned = preview.get().plan();
        view.show(planned, context.vocabulary(), net.drawn(planned));
        view.revealWhole(preview.get().changes().keySet());
    }

    private String emptyText() {
        return "This plan is empty. The palette has what to add: mark it and press Enter, or drag it here. "
                + key("net-add-place") + " adds a blank place, " + key("net-add-transition") + " a transition.";
    }

    private String key(String command) {
        return context.commands().get(command).keyText();
    }

    private JPopupMenu menu() {
        JPopupMenu menu = new JPopupMenu();
        menu.setName("net-menu");
        context.commands().refresh();
        for (String id : MENU) {
            if (id.isEmpty()) {
                menu.addSeparator();
            } else {
                context.commands()
                        .find(id)
                        .filter(command -> !command.isHidden())
                        .ifPresent(command -> menu.add(item(command)));
            }
        }
        JMenu patterns = new JMenu("Patterns");
        patterns.setName("net-menu-patterns");
        context.commands().all().stream()
                .filter(command -> command.id().startsWith("pattern-") && !command.isHidden())
                .forEach(command -> patterns.add(item(command)));
        if (patterns.getItemCount() > 0) {
            menu.addSeparator();
            menu.add(patterns);
        }
        return menu;
    }

    private static JMenuItem item(Command command) {
        JMenuItem item = new JMenuItem(command);
        item.setName("net-menu-" + command.id());
        return item;
    }

    /** Says what can come next at a vertex; nothing until somebody knows. */
    public void setAppendChoices(AppendChoices next) {
        actions.setAppendChoices(next);
    }

    @Override
    public void put(NetDrop drop) {
        Optional<Vertex> vertex = actions.selectedVertex();
        Optional<String> onto = vertex.map(Vertex::id)
                .filter(id -> drop.whyNotOnto(net.plan(), id).isEmpty());
        LayoutPoint free = vertex.map(v -> actions.behind(v.id())).orElseGet(() -> {
            LayoutPoint middle = view.centre();
            return net.free(middle.x(), middle.y());
        });
        actions.whyNotEdit("net-drop").ifPresentOrElse(actions::refuse, () -> actions.put(drop, onto, free));
    }

    /** Shows what stands where while the plan is tried; nothing with {@link NetMarking#EMPTY}. */
    public void showMarking(NetMarking marking) {
        this.marking = marking;
        view.setMarking(tokens ? marking : NetMarking.EMPTY);
    }

    @Override
    public Optional<ShownText> wordsAt(Component inner, Point at) {
        if (inner != view.canvas()) {
            return Optional.empty();
        }
        LayoutPoint point = view.point(at.x, at.y);
        int reach = (int) REACH_PX;
        return view.scene()
                .vertexAt(point.x(), point.y(), 0)
                .map(Vertex::id)
                .or(() -> view.scene()
                        .edgeAt(point.x(), point.y(), REACH_PX / view.zoom())
                        .map(Edge::id))
                .flatMap(id -> NetWords.of(net.plan(), id))
                .map(words -> ShownText.all(words, new Rectangle(at.x - reach, at.y - reach, 2 * reach, 2 * reach)));
    }

    @Override
    public Optional<String> words() {
        return context.editor().selection().stream()
                .flatMap(id -> NetWords.of(net.plan(), id).stream())
                .findFirst();
    }

    /** The net itself, for trying or printing the plan. */
    public NetView net() {
        return view;
    }
}
