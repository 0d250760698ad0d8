package org.sami.house

import groovy.xml.XmlSlurper

/** Counts the tests of JUnit's XML result files, so that the last word of a build is what was run, not what was planned. */
class TestCount {
    int passed
    int failed
    int skipped

    /** Adds every result file of one module's test task. */
    void addFolder(File folder) {
        folder.listFiles()?.findAll { it.name ==~ /TEST-.*\.xml/ }?.sort()?.each { addFile(it) }
    }

    private void addFile(File file) {
        def suite = new XmlSlurper(false, false).parse(file)
        int all = (suite.@tests.text() ?: '0') as int
        int bad = ((suite.@failures.text() ?: '0') as int) + ((suite.@errors.text() ?: '0') as int)
        int left = (suite.@skipped.text() ?: '0') as int
        passed += all - bad - left
        failed += bad
        skipped += left
    }

    @Override
    String toString() {
        "$passed passed, $failed failed" + (skipped > 0 ? ", $skipped skipped" : '')
    }
}
