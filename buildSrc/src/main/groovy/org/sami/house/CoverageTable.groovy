package org.sami.house

/** Which share of each module's lines and branches the tests run, as a table; read from JaCoCo's CSV files, which have a row for each class. */
class CoverageTable {
    private static final String ROW = '%-30s %8s %8s %10s %10s'

    private CoverageTable() {}

    /** The table of modules by their files; those of which no class was seen have none. */
    static String of(Map<String, File> files) {
        def counted = files.findAll { it.value.isFile() }.collectEntries { module, file -> [module, count(file)] }
        def sum = counted.values().toList().transpose()*.sum()
        def lines = [String.format(ROW, 'module', 'lines', 'run', 'branches', 'run')]
        counted.each { module, counts -> lines << row(module, counts) }
        if (counted.size() > 1) {
            lines << row('all', sum)
        }
        lines.join('\n')
    }

    /** Lines run, lines, branches run and branches of a file. */
    private static List<Integer> count(File csv) {
        def rows = csv.readLines()*.split(',')
        def at = { String column -> rows[0].toList().indexOf(column) }
        def total = { String column -> rows.drop(1).sum(0) { it[at(column)] as int } as int }
        int lines = total('LINE_COVERED')
        int branches = total('BRANCH_COVERED')
        [lines, lines + total('LINE_MISSED'), branches, branches + total('BRANCH_MISSED')]
    }

    private static String row(String module, List<Integer> counts) {
        String.format(ROW, module, counts[1], share(counts[0], counts[1]), counts[3], share(counts[2], counts[3]))
    }

    private static String share(int run, int all) {
        all == 0 ? '-' : String.format('%.1f %%', 100.0 * run / all)
    }
}
