package org.sami.ui.sheet;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JFileChooser;
import javax.swing.JTextField;
import javax.swing.UIManager;
import org.sami.ui.look.Look;
import org.sami.ui.look.Spacing;

/** Has a file chosen in a sheet of the window: the file chooser of Swing as a component, never as a dialog. On the event thread. */
public final class FileSheet {
    private static final String READ_ONLY = "FileChooser.readOnly";

    private final String name;
    private final String title;
    private Optional<Path> folder = Optional.empty();
    private Optional<Path> offered = Optional.empty();
    private boolean saves;
    private boolean folders;
    private Runnable closed = () -> {};

    /**
     * One that has a file opened.
     *
     * @param name of the sheet
     */
    public FileSheet(String name, String title) {
        this.name = Objects.requireNonNull(name, "name");
        this.title = Objects.requireNonNull(title, "title");
    }

    /** Begins in a folder. */
    public FileSheet from(Path begin) {
        folder = Optional.of(begin);
        return this;
    }

    /** Has a file named that will be written; this one is offered. */
    public FileSheet toSave(Path offer) {
        offered = Optional.of(offer);
        saves = true;
        return this;
    }

    /** Takes folders as well. */
    public FileSheet orFolder() {
        folders = true;
        return this;
    }

    /** Sets what is run when it was closed for any reason, before a chosen file is handed over. */
    public FileSheet whenClosed(Runnable told) {
        closed = told;
        return this;
    }

    /**
     * Opens it.
     *
     * @param inside lies in the window that shows it
     * @param chosen is given the file, unless the sheet is closed without one
     */
    public void open(Component inside, Consumer<Path> chosen) {
        Object before = UIManager.get(READ_ONLY);
        UIManager.put(READ_ONLY, true); // otherwise a failure to make a new folder opens a modal dialog
        JFileChooser chooser = new JFileChooser(folder.map(Path::toFile).orElse(null));
        UIManager.put(READ_ONLY, before);
        chooser.setName(name + "-chooser");
        chooser.getAccessibleContext().setAccessibleName(title);
        chooser.setDialogType(saves ? JFileChooser.SAVE_DIALOG : JFileChooser.OPEN_DIALOG);
        chooser.setFileSelectionMode(folders ? JFileChooser.FILES_AND_DIRECTORIES : JFileChooser.FILES_ONLY);
        offered.ifPresent(file -> chooser.setSelectedFile(file.toFile()));
        enlarge(chooser);
        WindowSheet sheet = WindowSheet.in(inside);
        chooser.addActionListener(event -> {
            boolean approved = JFileChooser.APPROVE_SELECTION.equals(event.getActionCommand());
            sheet.close();
            if (approved && chooser.getSelectedFile() != null) {
                chosen.accept(chooser.getSelectedFile().toPath());
            }
        });
        sheet.open(new Sheet(name, title, chooser).whenClosed(closed));
        find(chooser).ifPresent(Component::requestFocusInWindow);
    }

    private static Optional<Component> find(Container in) {
        for (Component child : in.getComponents()) {
            if (child instanceof JTextField) {
                return Optional.of(child);
            }
            Optional<Component> found = child instanceof Container inner ? find(inner) : Optional.empty();
            if (found.isPresent()) {
                return found;
            }
        }
        return Optional.empty();
    }

    private static void enlarge(Container in) {
        int least = Look.px(Spacing.HIT_TARGET_FIELD);
        for (Component child : in.getComponents()) {
            if (child instanceof AbstractButton || child instanceof JTextField || child instanceof JComboBox) {
                Dimension size = child.getPreferredSize();
                Dimension large = new Dimension(Math.max(least, size.width), Math.max(least, size.height));
                child.setPreferredSize(large);
                child.setMinimumSize(large);
                child.setMaximumSize(new Dimension(Math.max(large.width, child.getMaximumSize().width), large.height));
            } else if (child instanceof Container inner) {
                enlarge(inner);
            }
        }
    }
}
