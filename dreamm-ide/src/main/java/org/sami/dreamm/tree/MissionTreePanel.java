package org.sami.dreamm.tree;

import java.awt.BorderLayout;
import java.awt.CardLayout;
import java.awt.event.ActionEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.EditorListener;
import org.sami.palette.SemanticColor;
import org.sami.ui.command.Command;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.Spacing;

/** The mission tree with a field that searches everything: while something is typed there, what was found stands in the tree's place. */
public final class MissionTreePanel extends JPanel implements SearchView {
    private static final String TREE = "tree";
    private static final String HITS = "hits";

    /** The commands of the tree's menu. */
    private static final List<String> MENU = List.of(
            "plan-new",
            "folder-new",
            "rename",
            "plan-clone",
            "tree-delete",
            "plan-up",
            "plan-down",
            "tree-open",
            "usages-find");

    private final transient DreammContext context;
    private final JTextField search = new JTextField();
    private final CardLayout cards = new CardLayout();
    private final JPanel middle = new JPanel(cards);
    private final MissionTreeView tree;
    private final HitList hits;
    private final NameBar names;

    /** The panel of a window; its commands are added to the registry. */
    public MissionTreePanel(DreammContext context) {
        super(new BorderLayout());
        this.context = context;
        LookColors.background(this, SemanticColor.SURFACE);
        tree = new MissionTreeView(context);
        hits = new HitList(context, this::showTree);
        names = new NameBar(this::bringUp, tree::requestFocusInWindow);
        search.setName("search-everything-text");
        search.putClientProperty("JTextField.placeholderText", "Search everything (Ctrl+Shift+F)");
        search.putClientProperty("JTextField.showClearButton", true);
        search.getAccessibleContext().setAccessibleName("Search everything");
        JScrollPane scroll =
                new JScrollPane(tree, JScrollPane.VERTICAL_SCROLLBAR_AS_NEEDED, JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
        scroll.setBorder(BorderFactory.createEmptyBorder());
        middle.add(scroll, TREE);
        middle.add(hits, HITS);
        JPanel head = new JPanel(new BorderLayout());
        int inset = Look.px(Spacing.NORMAL);
        head.setOpaque(false);
        head.setBorder(BorderFactory.createEmptyBorder(inset, inset, inset, inset));
        head.add(search);
        add(head, BorderLayout.NORTH);
        add(middle);
        add(names, BorderLayout.SOUTH);
        new TreeCommands(context, tree, names, this).register();
        listen();
        tree.follow();
    }

    private void listen() {
        context.document().addListener(change -> {
            if (change.isOpened()) { // what was searched for belongs to the project before
                search.setText("");
                cards.show(middle, TREE);
            }
            tree.fill();
            tree.follow();
        });
        context.editor().addListener(new EditorListener() {
            @Override
            public void planOpened() {
                tree.follow();
            }
        });
        search.getDocument().addDocumentListener(new DocumentListener() {
            @Override
            public void insertUpdate(DocumentEvent e) {
                find();
            }

            @Override
            public void removeUpdate(DocumentEvent e) {
                find();
            }

            @Override
            public void changedUpdate(DocumentEvent e) {
                find();
            }
        });
        bind(search, "DOWN", hits::focusFirst);
        bind(search, "ENTER", hits::focusFirst);
        bind(search, "ESCAPE", this::showTree);
        tree.addMouseListener(new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent e) {
                menu(e);
                if (e.getClickCount() == 2) {
                    context.commands().get("tree-open").run();
                }
            }

            @Override
            public void mouseReleased(MouseEvent e) {
                menu(e);
            }
        });
    }

    private static void bind(JComponent component, String key, Runnable action) {
        component.getInputMap().put(KeyStroke.getKeyStroke(key), key);
        component.getActionMap().put(key, new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent e) {
                action.run();
            }
        });
    }

    private void menu(MouseEvent e) {
        int row = tree.getClosestRowForLocation(e.getX(), e.getY());
        if (e.isPopupTrigger() && row >= 0) {
            tree.setSelectionRow(row);
            JPopupMenu menu = new JPopupMenu();
            for (String id : MENU) {
                context.commands().find(id).filter(c -> !c.isHidden()).ifPresent(menu::add);
            }
            menu.show(tree, e.getX(), e.getY());
        }
    }

    private void find() {
        String typed = search.getText();
        if (typed.isBlank()) {
            cards.show(middle, TREE);
            return;
        }
        List<Hit> found = new ProjectSearch(context.document().project(), context.vocabulary()).find(typed);
        showHits(found.isEmpty() ? "Nothing says \"" + typed + "\"" : found.size() + " found", found);
    }

    @Override
    public void showHits(String title, List<Hit> found) {
        hits.showHits(title, found);
        cards.show(middle, HITS);
    }

    /** Shows the panel where it lies behind another or is folded. */
    void bringUp() {
        if (!isShowing()) {
            context.commands().find("panel-mission-tree").ifPresent(Command::run);
        }
    }

    @Override
    public void focusHits() {
        bringUp();
        hits.focusFirst();
    }

    @Override
    public void focusSearch() {
        bringUp();
        search.requestFocusInWindow();
        search.selectAll();
    }

    private void showTree() {
        search.setText("");
        cards.show(middle, TREE);
        tree.requestFocusInWindow();
    }
}
