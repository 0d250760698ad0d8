package org.sami.dreamm.file;

import java.awt.Component;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import javax.swing.JFileChooser;
import javax.swing.filechooser.FileNameExtensionFilter;

/** Asks for files. On the event thread. */
final class FileDialogs {
    private final Component owner;
    private Path folder;

    /** Dialogs over a window that begin in a folder. */
    FileDialogs(Component owner, Path folder) {
        this.owner = owner;
        this.folder = folder;
    }

    /** A file or folder that is there. */
    Optional<Path> open(String title, String kind, String extension) {
        JFileChooser chooser = chooser(title);
        chooser.setFileFilter(new FileNameExtensionFilter(kind, extension));
        return chosen(chooser, chooser.showOpenDialog(owner));
    }

    /** A file that a project is written to, with its ending, or a folder that is there. */
    Optional<Path> save(String title, String proposed) {
        JFileChooser chooser = chooser(title);
        chooser.setFileFilter(new FileNameExtensionFilter("Project files, or a folder that is there", "json"));
        chooser.setSelectedFile(folder.resolve(proposed + ".json").toFile());
        return chosen(chooser, chooser.showSaveDialog(owner)).map(FileDialogs::withEnding);
    }

    /** A folder, there or not. */
    Optional<Path> folder(String title) {
        JFileChooser chooser = chooser(title);
        chooser.setFileSelectionMode(JFileChooser.DIRECTORIES_ONLY);
        return chosen(chooser, chooser.showSaveDialog(owner));
    }

    private JFileChooser chooser(String title) {
        JFileChooser chooser = new JFileChooser(folder.toFile());
        chooser.setName("file-chooser");
        chooser.setDialogTitle(title);
        chooser.setFileSelectionMode(JFileChooser.FILES_AND_DIRECTORIES);
        return chooser;
    }

    private Optional<Path> chosen(JFileChooser chooser, int answer) {
        if (answer != JFileChooser.APPROVE_OPTION) {
            return Optional.empty();
        }
        Path path = chooser.getSelectedFile().toPath().toAbsolutePath().normalize();
        folder = Optional.ofNullable(path.getParent()).orElse(folder);
        return Optional.of(path);
    }

    private static Path withEnding(Path path) {
        String name = path.getFileName().toString();
        return java.nio.file.Files.isDirectory(path)
                        || name.toLowerCase(Locale.ROOT).endsWith(".json")
                ? path
                : path.resolveSibling(name + ".json");
    }
}
