package org.sami.dreamm.window;

import java.util.List;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import org.sami.dreamm.file.FileCommands;
import org.sami.dreamm.file.RecentMenu;
import org.sami.spn.statespace.DeepChecks;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandRegistry;
import org.sami.ui.dock.DockPanel;
import org.sami.ui.window.CommandMenus;

/** The menus: every command of the window, by what it is about. */
final class DreammMenus {
    private DreammMenus() {}

    static JMenuBar bar(CommandRegistry commands, FileCommands files, List<DockPanel> panels) {
        CommandMenus menus = new CommandMenus(commands);
        JMenuBar bar = new JMenuBar();
        bar.setName("menus");
        JMenu file = menus.menu("File", 'F', "project-new", "project-open", "library-open");
        commands.find("project-open").filter(Command::isEnabled).ifPresent(open -> file.add(RecentMenu.of(files)));
        menus.add(
                file,
                "",
                "project-save",
                "project-save-as",
                "project-save-folder",
                "",
                "import-legacy",
                "import-geometry",
                "",
                "plan-export-png",
                "plan-export-svg",
                "plan-export-pdf",
                "",
                "end");
        bar.add(file);
        bar.add(menus.menu(
                "Edit",
                'E',
                "undo",
                "redo",
                "",
                "net-cut",
                "net-copy",
                "net-paste",
                "net-duplicate",
                "net-delete",
                "",
                "net-select-all",
                "net-rename",
                "",
                "rename",
                "usages-find",
                "search-everything"));
        bar.add(menus.menu(
                "Plan",
                'P',
                "plan-new",
                "plan-clone",
                "tree-delete",
                "",
                "folder-new",
                "plan-up",
                "plan-down",
                "",
                "plan-compare-saved",
                "plan-compare-file"));
        bar.add(menus.menu(
                "Net",
                'N',
                "net-add-place",
                "net-add-transition",
                "net-connect",
                "net-append",
                "net-add-note",
                "net-add-frame",
                "net-disable",
                "net-extract",
                "",
                "net-layout-layers",
                "net-layout-forces",
                "net-layout-distances",
                "net-align-row",
                "net-align-column",
                "net-align-spread-x",
                "net-align-spread-y",
                "net-snap",
                "",
                "net-mode-nominal",
                "net-mode-recovery",
                "net-mode-all",
                "net-show-events",
                "net-show-markups",
                "net-show-requirements",
                "net-show-tokens"));
        bar.add(menus.menu(
                "Patterns",
                'A',
                commands.ids().stream().filter(id -> id.startsWith("pattern-")).toArray(String[]::new)));
        bar.add(menus.menu(
                "Try",
                'T',
                "try-start",
                "try-start-at",
                "try-restart",
                "try-stop",
                "",
                "try-step",
                "try-run",
                "try-back",
                "try-breakpoint",
                "try-why",
                "",
                "try-cases",
                "try-coverage",
                "",
                "query-all",
                "query-one",
                "query-happen",
                "query-stop",
                "query-show",
                "query-back",
                "query-next",
                "query-play",
                "query-remove",
                "query-graph",
                "query-bounds",
                "",
                "replay-open",
                "replay-close"));
        JMenu issues = menus.menu(
                "Issues",
                'I',
                "issue-next",
                "issue-previous",
                "issue-show",
                "issue-fix",
                "issue-play",
                "",
                "edge-suggest",
                "");
        DeepChecks.ALL.forEach(check -> menus.add(issues, "deep-" + check.id()));
        menus.add(issues, "deep-stop");
        bar.add(issues);
        bar.add(menus.view(panels));
        bar.add(menus.menu(
                "Learn",
                'L',
                "learn-open",
                "learn-next",
                "learn-back",
                "learn-contents",
                "learn-glossary",
                "",
                "learn-check",
                "learn-cancel",
                "learn-reveal",
                "learn-explained",
                "learn-hint",
                "learn-failure",
                "learn-compare",
                "learn-start-over",
                "",
                "learn-run-forward",
                "learn-run-back",
                "learn-run-restart",
                "",
                "learn-leave"));
        JMenu help = menus.help();
        menus.add(help, "", "help-here", "words-here", "words-hover");
        bar.add(help);
        for (int i = bar.getMenuCount() - 1; i >= 0; i--) {
            if (bar.getMenu(i).getItemCount() == 0) { // a profile hides all of it
                bar.remove(i);
            }
        }
        return bar;
    }
}
